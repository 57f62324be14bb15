/* tail.c: texels of the tail by a least-squares fit, reweighted towards the smallest largest error.
 *
 * Sampling the tail would do, but bilinear interpolation of a convex function is too large
 * everywhere between the texels: fitted texels halve the error. */
#include "tail.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "sg.h"

enum { PER_CELL = 8, LINE = (TAIL_SIZE - 1) * PER_CELL + 1, TEXELS = TAIL_SIZE * TAIL_SIZE };

typedef struct sample {
    int corner;           /* texel at the cell's low corner */
    double weights[4];    /* of the four texels: corner, right, below, both */
    double target, scale; /* T sqrt(lambda + 2); 1/sqrt(lambda + 2) makes it an error of L */
    double emphasis;
} sample;

static const int step[4] = {0, 1, TAIL_SIZE, TAIL_SIZE + 1};

static double interpolate(const double *texels, const sample *at)
{
    double sum = 0;
    for (int k = 0; k < 4; k++)
        sum += at->weights[k] * texels[at->corner + step[k]];
    return sum;
}

/* Place in the table: u and v in [0, 1]. */
static void place(sample *at, double u, double v)
{
    double x = u * (TAIL_SIZE - 1), y = v * (TAIL_SIZE - 1);
    double i = fmin(floor(x), TAIL_SIZE - 2), j = fmin(floor(y), TAIL_SIZE - 2);
    x -= i;
    y -= j;
    at->corner = (int)j * TAIL_SIZE + (int)i;
    at->weights[0] = (1 - x) * (1 - y);
    at->weights[1] = x * (1 - y);
    at->weights[2] = (1 - x) * y;
    at->weights[3] = x * y;
}

/* T sqrt(lambda + 2); at u = 1 the planar limit. c beyond 1 counts as 1. */
static double scaled_tail(double u, double v)
{
    if (u >= 1) {
        double x = v * TAIL_REACH;
        return exp(-0.5 * x * x) * 0.39894228040143268 - 0.5 * x * erfc(x * 0.70710678118654752);
    }
    double root = sqrt(2 / (1 - u)), c = fmin(v * TAIL_REACH / root, 1.0);
    return sg_L_cos(2 * u / (1 - u), -c) * root;
}

static size_t make_samples(sample *samples)
{
    size_t count = 0;
    for (int j = 0; j < LINE; j++) {
        for (int i = 0; i < LINE; i++) {
            double u = (double)i / (LINE - 1), v = (double)j / (LINE - 1);
            double scale = sqrt(0.5 * (1 - u));
            if (v * TAIL_REACH * scale > 1)
                continue;
            sample *at = &samples[count++];
            place(at, u, v);
            at->target = scaled_tail(u, v);
            /* A scale of 0 at infinite sharpness would leave those texels free. */
            at->scale = fmax(scale, 0.01);
            at->emphasis = 1;
        }
    }
    return count;
}

/* The row at the tail's end and the column at infinite sharpness stay at the function's values:
 * what is beyond them sees nothing else. */
static void hold_edges(double *change)
{
    for (int i = 0; i < TAIL_SIZE; i++) {
        change[(TAIL_SIZE - 1) * TAIL_SIZE + i] = 0;
        change[i * TAIL_SIZE + TAIL_SIZE - 1] = 0;
    }
}

/* out = (sum over samples of weight w w^T) x, the normal matrix, for the texels that are not held.
 */
static void normal_product(const sample *samples, size_t count, const double *x, double *out)
{
    memset(out, 0, TEXELS * sizeof *out);
    for (size_t s = 0; s < count; s++) {
        const sample *at = &samples[s];
        double value = interpolate(x, at) * at->scale * at->scale * at->emphasis;
        for (int k = 0; k < 4; k++)
            out[at->corner + step[k]] += at->weights[k] * value;
    }
    hold_edges(out);
}

static double dot(const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < TEXELS; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Conjugate gradients on the weighted normal equations, from the texels given. */
static void solve(const sample *samples, size_t count, double *texels)
{
    static const int steps = 40;
    double *r = base_allocate(3 * TEXELS * sizeof *r), *p = r + TEXELS, *q = p + TEXELS;
    memset(r, 0, TEXELS * sizeof *r);
    for (size_t s = 0; s < count; s++) {
        const sample *at = &samples[s];
        double residual =
            (at->target - interpolate(texels, at)) * at->scale * at->scale * at->emphasis;
        for (int k = 0; k < 4; k++)
            r[at->corner + step[k]] += at->weights[k] * residual;
    }
    hold_edges(r);
    memcpy(p, r, TEXELS * sizeof *p);
    double size = dot(r, r);
    for (int n = 0; n < steps && size > 0; n++) {
        normal_product(samples, count, p, q);
        double along = size / dot(p, q);
        for (int i = 0; i < TEXELS; i++) {
            texels[i] += along * p[i];
            r[i] -= along * q[i];
        }
        double next = dot(r, r);
        for (int i = 0; i < TEXELS; i++)
            p[i] = r[i] + next / size * p[i];
        size = next;
    }
    free(r);
}

static double largest_error(const sample *samples, size_t count, const double *texels)
{
    double largest = 0;
    for (size_t s = 0; s < count; s++)
        largest = fmax(largest, fabs(interpolate(texels, &samples[s]) - samples[s].target) *
                                    samples[s].scale);
    return largest;
}

void tail_fit(double texels[TEXELS])
{
    enum { ROUNDS = 4 }; /* 40 would gain 2 % */
    sample *samples = base_allocate((size_t)LINE * LINE * sizeof *samples);
    size_t count = make_samples(samples);
    for (int j = 0; j < TAIL_SIZE; j++) {
        for (int i = 0; i < TAIL_SIZE; i++)
            texels[j * TAIL_SIZE + i] =
                scaled_tail((double)i / (TAIL_SIZE - 1), (double)j / (TAIL_SIZE - 1));
    }
    double best = largest_error(samples, count, texels), trial[TEXELS];
    memcpy(trial, texels, sizeof trial);
    for (int round = 0; round < ROUNDS; round++) {
        solve(samples, count, trial);
        double largest = largest_error(samples, count, trial);
        if (largest < best) {
            best = largest;
            memcpy(texels, trial, sizeof trial);
        }
        /* Samples with large errors count more in the next round (Lawson). */
        for (size_t s = 0; s < count; s++) {
            double error =
                fabs(interpolate(trial, &samples[s]) - samples[s].target) * samples[s].scale;
            samples[s].emphasis *= 0.1 + error / largest;
        }
    }
    free(samples);
    for (int i = 0; i < TEXELS; i++)
        texels[i] = fmax(texels[i], 0.0);
}

double tail_lookup(const double texels[TEXELS], double lambda, double c)
{
    sample at;
    double root = sqrt(lambda + 2);
    place(&at, 1 - 2 / (lambda + 2), fmin(c * root / TAIL_REACH, 1));
    return interpolate(texels, &at) / root;
}
