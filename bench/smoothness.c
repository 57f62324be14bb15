/* smoothness.c: see smoothness.h. */
#include "smoothness.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "kinks.h"

enum { PER_DECADE = 8, LOWEST = -4, HIGHEST = 4, SAMPLES = 1025, COSINES = 33, KINKS = 32 };

typedef struct line {
    const sg_method *method;
    double fixed;
} line;

static double along_z(const void *context, double z)
{
    const line *l = context;
    return l->method->L_f64(l->fixed, z);
}

static double along_logarithm(const void *context, double t)
{
    const line *l = context;
    return l->method->L_f64(pow(10, t), l->fixed);
}

/* Below least it is double's rounding. */
static void consider(smoothness_place *place, double amount, double lambda, double cos_theta)
{
    const double least = 1e-12;
    if (fabs(amount) > fmax(place->amount, least))
        *place = (smoothness_place){fabs(amount), lambda, cos_theta};
}

static void jumps_along_z(const sg_method *method, double lambda, smoothness *found)
{
    line l = {method, lambda};
    kink kinks[KINKS];
    size_t n = kinks_find(along_z, &l, -1, 1, SAMPLES, kinks, KINKS);
    for (size_t i = 0; i < n; i++) {
        consider(&found->slope_z, kinks[i].slope, lambda, kinks[i].at);
        consider(&found->step, kinks[i].step, lambda, kinks[i].at);
    }
}

static void jumps_along_lambda(const sg_method *method, double cos_theta, double low, double high,
                               smoothness *found)
{
    line l = {method, cos_theta};
    kink kinks[KINKS];
    size_t n = kinks_find(along_logarithm, &l, log10(low), log10(high), SAMPLES, kinks, KINKS);
    for (size_t i = 0; i < n; i++) {
        double lambda = pow(10, kinks[i].at);
        consider(&found->slope_lambda, kinks[i].slope / (lambda * log(10)), lambda, cos_theta);
        consider(&found->step, kinks[i].step, lambda, cos_theta);
    }
}

static void falls(const sg_method *method, double lambda, smoothness *found)
{
    double most = -HUGE_VAL, most_f32 = -HUGE_VAL;
    for (int i = 0; i < SAMPLES; i++) {
        double z = 2.0 * i / (SAMPLES - 1) - 1, value = method->L_f64(lambda, z);
        double value_f32 = (double)method->L_f32((float)lambda, (float)z);
        most = fmax(most, value);
        most_f32 = fmax(most_f32, value_f32);
        consider(&found->fall, most - value, lambda, z);
        consider(&found->fall_f32, most_f32 - value_f32, lambda, z);
    }
}

void smoothness_of(const sg_method *method, smoothness *found)
{
    *found = (smoothness){{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    double low = fmax(method->lambda_min, pow(10, LOWEST));
    double high = fmin(method->lambda_max, pow(10, HIGHEST));
    for (int i = LOWEST * PER_DECADE; i <= HIGHEST * PER_DECADE; i++) {
        double lambda = pow(10, (double)i / PER_DECADE);
        if (lambda < low || lambda > high)
            continue;
        jumps_along_z(method, lambda, found);
        falls(method, lambda, found);
    }
    for (int i = 0; i < COSINES; i++)
        jumps_along_lambda(method, 2.0 * i / (COSINES - 1) - 1, low, high, found);
}

typedef struct work {
    const sg_method **methods;
    smoothness *found;
} work;

static void one_method(void *context, size_t index)
{
    const work *w = context;
    smoothness_of(w->methods[index], &w->found[index]);
}

static void print_place(FILE *out, const smoothness_place *place)
{
    char text[3][BASE_NUMBER_SIZE], rounded[BASE_NUMBER_SIZE];
    double shown[3] = {place->amount, place->lambda, place->cos_theta};
    for (int i = 0; i < 3; i++) {
        snprintf(rounded, sizeof rounded, "%.*g", i ? 7 : 4, shown[i]);
        base_parse_f64(rounded, strlen(rounded), &shown[i]);
        base_shortest_f64(shown[i], text[i]);
    }
    if (place->amount > 0)
        fprintf(out, ",%s,%s,%s", text[0], text[1], text[2]);
    else
        fputs(",0,,", out);
}

static bool write(const work *w, size_t count, const char *path)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fputs("method", output.stream);
    static const char *const names[] = {"slope_jump_z", "slope_jump_lambda", "step", "fall_z",
                                        "fall_z_f32"};
    for (int i = 0; i < 5; i++)
        fprintf(output.stream, ",%s,%s_at_lambda,%s_at_cos_theta", names[i], names[i], names[i]);
    fputs("\n", output.stream);
    for (size_t i = 0; i < count; i++) {
        const smoothness *s = &w->found[i];
        const smoothness_place *places[] = {&s->slope_z, &s->slope_lambda, &s->step, &s->fall,
                                            &s->fall_f32};
        fputs(w->methods[i]->id, output.stream);
        for (int k = 0; k < 5; k++)
            print_place(output.stream, places[k]);
        fputs("\n", output.stream);
    }
    return base_output_close(&output);
}

bool smoothness_write(const char *only, const char *path)
{
    work w = {malloc(sg_method_count() * sizeof *w.methods),
              malloc(sg_method_count() * sizeof *w.found)};
    size_t count = 0;
    bool good = w.methods && w.found;
    for (size_t i = 0; good && i < sg_method_count(); i++)
        if (!only || strcmp(only, sg_method_at(i)->id) == 0)
            w.methods[count++] = sg_method_at(i);
    if (good) {
        base_parallel(count, one_method, &w);
        good = write(&w, count, path);
    } else
        base_error("%s: out of memory", path);
    free(w.methods);
    free(w.found);
    return good;
}
