/* stability_seams.c: both sides of the seams of a piecewise formula, as rows for the scan. */
#include <math.h>
#include <stdlib.h>

#include "kinks.h"
#include "stability_private.h"

void stability_seams_free(stability_seams *seams)
{
    free(seams->list);
    *seams = (stability_seams){0};
}

static double next(stability_precision precision, double value, double towards)
{
    double step = precision == STABILITY_F64   ? 0x1p-52
                  : precision == STABILITY_F16 ? 0x1p-10
                                               : 0x1p-23;
    double moved = value + (towards > value ? 1 : -1) * fmax(fabs(value), 0x1p-126) * step;
    return stability_rounded(precision, moved);
}

static void add(stability_seams *seams, stability_precision precision, double lambda,
                double cos_theta)
{
    if (seams->count == seams->capacity) {
        seams->capacity = seams->capacity ? 2 * seams->capacity : 64;
        seams->list = realloc(seams->list, seams->capacity * sizeof *seams->list);
        if (!seams->list)
            abort();
    }
    stability_seam *seam = &seams->list[seams->count++];
    double centre = stability_rounded(precision, cos_theta);
    *seam = (stability_seam){lambda, {0}, 3};
    seam->cos_theta[0] = next(precision, centre, -2);
    seam->cos_theta[1] = centre;
    seam->cos_theta[2] = next(precision, centre, 2);
}

void stability_seam_add(stability_seams *seams, stability_precision precision, double lambda,
                        double cos_theta)
{
    double centre = stability_rounded(precision, lambda);
    if (!(centre >= 0 && isfinite(centre))) /* beyond half */
        return;
    double below = next(precision, centre, -1), above = next(precision, centre, HUGE_VAL);
    /* the cosine that belongs to it is known: three rows with all cosines and those next to it */
    add(seams, precision, centre, cos_theta);
    if (below >= 0)
        add(seams, precision, below, cos_theta);
    add(seams, precision, above, cos_theta);
}

typedef struct line {
    double (*L)(double, double);
    double fixed;
} line;

static double along_lambda(const void *context, double t)
{
    const line *l = context;
    return l->L(pow(10, t), l->fixed);
}

static double along_cos_theta(const void *context, double t)
{
    const line *l = context;
    return l->L(l->fixed, t);
}

void stability_seams_in_values(double (*L)(double, double), stability_precision precision,
                               stability_seams *seams)
{
    enum { MOST = 16 };
    static const double cosines[] = {-1, -0.8, -0.3, -0.01, 0, 0.01, 0.3, 0.8, 1};
    kink found[MOST];
    for (size_t i = 0; i < sizeof cosines / sizeof *cosines; i++) {
        line l = {L, cosines[i]};
        size_t n = kinks_find(along_lambda, &l, -8, 8, 1025, found, MOST);
        for (size_t k = 0; k < n; k++)
            stability_seam_add(seams, precision, pow(10, found[k].at), cosines[i]);
    }
    for (int i = -12; i <= 20; i++) {
        line l = {L, pow(10, i / 4.0)};
        size_t n = kinks_find(along_cos_theta, &l, -1, 1, 513, found, MOST);
        for (size_t k = 0; k < n; k++)
            stability_seam_add(seams, precision, l.fixed, found[k].at);
    }
}
