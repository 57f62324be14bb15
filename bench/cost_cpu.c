/* cost_cpu.c: nanoseconds of an evaluation on one core. */
#include "cost.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "base/order.h"

const double cost_lambda_min = 1e-2, cost_lambda_max = 1e4;

void cost_points_fill(cost_points *points)
{
    /* Additive recurrence with the plastic number: even in both dimensions for any length. */
    const double a = 0.7548776662466927, b = 0.5698402909980532;
    double x = 0.5, y = 0.5;
    for (size_t i = 0; i < COST_POINTS; i++) {
        x += a;
        y += b;
        x -= floor(x);
        y -= floor(y);
        points->lambda[i] = cost_lambda_min * pow(cost_lambda_max / cost_lambda_min, x);
        points->cos_theta[i] = 2 * y - 1;
        points->lambda_f32[i] = (float)points->lambda[i];
        points->cos_theta_f32[i] = (float)points->cos_theta[i];
    }
}

/* One pass over the points with whatever is being timed. */
typedef struct work {
    const cost_points *points;
    void (*pass)(const struct work *work, void *out);
    float (*f32)(float, float);
    double (*f64)(double, double);
    void (*batch_f32)(size_t, const float *, const float *, float *);
    void (*batch_f64)(size_t, const double *, const double *, double *);
} work;

static void pass_f32(const work *work, void *out)
{
    float *values = out;
    for (size_t i = 0; i < COST_POINTS; i++)
        values[i] = work->f32(work->points->lambda_f32[i], work->points->cos_theta_f32[i]);
}

static void pass_f64(const work *work, void *out)
{
    double *values = out;
    for (size_t i = 0; i < COST_POINTS; i++)
        values[i] = work->f64(work->points->lambda[i], work->points->cos_theta[i]);
}

static void pass_batch_f32(const work *work, void *out)
{
    work->batch_f32(COST_POINTS, work->points->lambda_f32, work->points->cos_theta_f32, out);
}

static void pass_batch_f64(const work *work, void *out)
{
    work->batch_f64(COST_POINTS, work->points->lambda, work->points->cos_theta, out);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* Nanoseconds of `passes` passes. */
static double run(const work *work, int passes, double *out)
{
    double start = now();
    for (int i = 0; i < passes; i++)
        work->pass(work, out);
    return now() - start;
}

static cost_time measure(const work *work, int samples)
{
    enum { LONGEST = 64 };
    static const double sample_time = 1e6; /* nanoseconds: far above the clock's own */
    double *out = malloc(COST_POINTS * sizeof *out);
    double times[LONGEST];
    if (!out)
        abort();
    if (samples > LONGEST)
        samples = LONGEST;
    double warm = run(work, 1, out);
    int passes = 1;
    while (warm < sample_time && passes < 1 << 20) {
        passes *= 2;
        warm = run(work, passes, out);
    }
    for (int i = 0; i < samples; i++)
        times[i] = run(work, passes, out) / ((double)passes * COST_POINTS);
    free(out);
    double median = base_median(times, (size_t)samples); /* sorts them */
    return (cost_time){times[0], median};
}

cost_time cost_time_f32(const cost_points *points, float (*f)(float, float), int samples)
{
    return measure(&(work){.points = points, .pass = pass_f32, .f32 = f}, samples);
}

cost_time cost_time_f64(const cost_points *points, double (*f)(double, double), int samples)
{
    return measure(&(work){.points = points, .pass = pass_f64, .f64 = f}, samples);
}

cost_time cost_time_batch_f32(const cost_points *points,
                              void (*f)(size_t, const float *, const float *, float *), int samples)
{
    return measure(&(work){.points = points, .pass = pass_batch_f32, .batch_f32 = f}, samples);
}

cost_time cost_time_batch_f64(const cost_points *points,
                              void (*f)(size_t, const double *, const double *, double *),
                              int samples)
{
    return measure(&(work){.points = points, .pass = pass_batch_f64, .batch_f64 = f}, samples);
}
