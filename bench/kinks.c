/* kinks.c: see kinks.h.
 *
 * The fourth difference of a smooth function falls with the fourth power of the spacing h, that of
 * one with a kink is as large as (jump of the slope) h, and a step stays what it is. So the part of
 * an interval with the largest fourth difference is taken again and again until only rounding is
 * left, and value and slope are then taken on either side. */
#include "kinks.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

typedef struct search {
    kink_function f;
    const void *context;
    double from, to;
} search;

static double value(const search *s, double t)
{
    return s->f(s->context, t);
}

/* Of five values: 0 for every cubic. */
static double fourth(double a, double b, double c, double d, double e)
{
    return fabs(a - 4.0 * b + 6.0 * c - 4.0 * d + e);
}

static double bend(const search *s, double a, double b)
{
    double q = 0.25 * (b - a), m = a + 2.0 * q;
    return fourth(value(s, a), value(s, m - q), value(s, m), value(s, m + q), value(s, b));
}

/* What the function's own rounding makes of a fourth difference near t: where the spacing is next
 * to nothing there is nothing else. */
static double noise_near(const search *s, double t, double spacing)
{
    double most = 16.0 * DBL_EPSILON * fabs(value(s, t)) + DBL_MIN;
    for (int i = -4; i < 4; i++) {
        double a = t + (i + 0.37) * 0.1 * spacing;
        if (a > s->from && a + 1e-7 * spacing < s->to)
            most = fmax(most, bend(s, a, a + 1e-7 * spacing));
    }
    return most;
}

/* Narrows [a, b] to where it bends most, until that is rounding alone or nothing is between. */
static void narrow(const search *s, double *a, double *b, double noise)
{
    for (int i = 0; i < 80; i++) {
        double quarter = 0.25 * (*b - *a), middle = *a + 2.0 * quarter;
        if (!(quarter > 8.0 * DBL_EPSILON * fmax(fabs(*a), fabs(*b)) && quarter > 1e-300))
            return;
        double left = bend(s, *a, middle), right = bend(s, middle, *b);
        double centre = bend(s, *a + quarter, *b - quarter);
        double most = fmax(centre, fmax(left, right));
        if (!(most > 2.0 * noise))
            return;
        if (most == centre) {
            *a += quarter;
            *b -= quarter;
        } else if (most == left)
            *b = middle;
        else
            *a = middle;
    }
}

/* The first derivative at t from the side that h points to, of the second order; and the second. */
static double slope(const search *s, double t, double h, double *curvature)
{
    double f0 = value(s, t), f1 = value(s, t + h), f2 = value(s, t + 2.0 * h);
    if (curvature)
        *curvature = (f0 - 2.0 * f1 + f2) / (h * h);
    return (-3.0 * f0 + 4.0 * f1 - f2) / (2.0 * h);
}

/* False where nothing jumps there. */
static bool measure(const search *s, double a, double b, double spacing, kink *found)
{
    double noise = noise_near(s, 0.5 * (a + b), spacing);
    narrow(s, &a, &b, noise);
    double at = 0.5 * (a + b), gap = fmax(b - a, 8.0 * DBL_EPSILON * fabs(at));
    double h = fmax(1e-3 * spacing, 4.0 * gap), above_bend, below_bend;
    if (at - 4.0 * h < s->from || at + 4.0 * h > s->to)
        return false;
    double rise = slope(s, at + gap, h, &above_bend), fall = slope(s, at - gap, -h, &below_bend);
    /* the same with a third of the spacing: how far the slopes can be trusted */
    double finer = slope(s, at + gap, h / 3.0, NULL) - slope(s, at - gap, -h / 3.0, NULL);
    double jump = rise - fall;
    double doubt = 2.0 * fabs(jump - finer) + 4.0 * gap * (fabs(above_bend) + fabs(below_bend)) +
                   8.0 * noise / h;
    *found = (kink){.at = at};
    found->slope = fabs(jump) > doubt ? jump : 0.0;
    /* what is left of the interval is crossed with the slope */
    double step = value(s, at + gap) - value(s, at - gap) - gap * (rise + fall);
    found->step = fabs(step) > 8.0 * noise + gap * (fabs(jump) + doubt) ? step : 0.0;
    return isfinite(found->step) && isfinite(found->slope) &&
           (found->step != 0.0 || found->slope != 0.0);
}

/* Larger than what is around it, though not by being next to a larger one. */
static bool stands_out(const double *bends, size_t count, size_t i)
{
    if ((i > 0 && bends[i - 1] > bends[i]) || (i + 1 < count && bends[i + 1] > bends[i]))
        return false;
    size_t reach = 7, n = 0;
    double around = 0;
    for (size_t k = i > reach ? i - reach : 0; k < count && k <= i + reach; k++)
        if (k + 3 < i || k > i + 3) {
            around += bends[k];
            n++;
        }
    return n > 0 && bends[i] > 2.0 * around / (double)n;
}

size_t kinks_find(kink_function f, const void *context, double from, double to, size_t samples,
                  kink *kinks, size_t most)
{
    search s = {f, context, from, to};
    double spacing = (to - from) / (double)(samples - 1);
    double *v = malloc(2 * samples * sizeof *v), *bends = v + samples;
    if (!v)
        return 0;
    for (size_t i = 0; i < samples; i++)
        v[i] = value(&s, from + spacing * (double)i);
    size_t count = samples - 4, found = 0;
    for (size_t i = 0; i < count; i++)
        bends[i] = fourth(v[i], v[i + 1], v[i + 2], v[i + 3], v[i + 4]);
    for (size_t i = 0; i < count && found < most; i++) {
        double a = from + spacing * (double)i;
        if (!stands_out(bends, count, i) ||
            !measure(&s, a, a + 4.0 * spacing, spacing, &kinks[found]))
            continue;
        if (found == 0 || kinks[found].at - kinks[found - 1].at > 1e-3 * spacing)
            found++;
    }
    free(v);
    return found;
}
