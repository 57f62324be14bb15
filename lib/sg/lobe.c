/* lobe.c: lobe algebra. Every difference that the papers print as one of large numbers is written
 * here as a product. */
#include "sg.h"

#include <float.h>
#include <math.h>

#include "kernel.h"

static double length3(const double v[3])
{
    return hypot(hypot(v[0], v[1]), v[2]);
}

/* |a - b|^2, which for unit vectors is 2 (1 - a.b) */
static double distance_squared(const double a[3], const double b[3])
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

/* a.b with an error of about one rounding of the result, next to the horizon as well */
static double dot3(const double a[3], const double b[3])
{
    sg_double2 x = sg_two_product(a[0], b[0]), y = sg_two_product(a[1], b[1]),
               z = sg_two_product(a[2], b[2]);
    sg_double2 xy = sg_two_sum(x.hi, y.hi), sum = sg_two_sum(xy.hi, z.hi);
    return sum.hi + (sum.lo + xy.lo + x.lo + y.lo + z.lo);
}

double sg_difference_of_products(double a, double b, double c, double d)
{
    double cd = c * d, rounding = fma(-c, d, cd);
    return fma(a, b, -cd) + rounding;
}

double sg_lobe_evaluate(const sg_lobe *lobe, const double direction[3])
{
    double square = distance_squared(direction, lobe->axis);
    if (square == 0.0) /* at the axis of an infinitely sharp lobe too */
        return lobe->amplitude;
    return lobe->amplitude * exp(-0.5 * square * lobe->sharpness);
}

double sg_lobe_integral(const sg_lobe *lobe)
{
    return lobe->amplitude * sg_A(lobe->sharpness);
}

double sg_lobe_irradiance(const sg_lobe *lobe, const double normal[3])
{
    return lobe->amplitude * sg_A_h_cos(lobe->sharpness, dot3(lobe->axis, normal));
}

/* A unit vector perpendicular to `axis`: its cross product with the coordinate axis that it is
 * farthest from. */
static void perpendicular(const double axis[3], double out[3])
{
    double x = fabs(axis[0]), y = fabs(axis[1]), z = fabs(axis[2]);
    int least = x <= y ? (x <= z ? 0 : 2) : (y <= z ? 1 : 2);
    int next = (least + 1) % 3, last = (least + 2) % 3;
    double size = hypot(axis[next], axis[last]);
    out[least] = 0.0;
    out[next] = size > 0.0 ? -axis[last] / size : 1.0;
    out[last] = size > 0.0 ? axis[next] / size : 0.0;
}

/* With M >= m the two sharpnesses and d = |v - w| the distance of the axes,
 *     M v + m w = M u,   u = (m/M) (v + w) + ((M - m)/M) v,
 * where for nearly opposite axes v + w and M - m are exact and the two terms perpendicular; and
 *     |M u| - M - m = -m d^2/(|u| + 1 + m/M),
 * the exponent that the paper prints as a difference. */
sg_lobe sg_lobe_product(const sg_lobe *a, const sg_lobe *b)
{
    const sg_lobe *sharp = a->sharpness >= b->sharpness ? a : b, *broad = sharp == a ? b : a;
    double ratio = 0.0, rest = 1.0;
    if (isinf(broad->sharpness)) {
        ratio = 1.0, rest = 0.0;
    } else if (sharp->sharpness > 0.0 && !isinf(sharp->sharpness)) {
        ratio = broad->sharpness / sharp->sharpness;
        rest = (sharp->sharpness - broad->sharpness) / sharp->sharpness;
    }
    double u[3];
    for (int i = 0; i < 3; i++)
        u[i] = ratio * (sharp->axis[i] + broad->axis[i]) + rest * sharp->axis[i];
    double size = length3(u), square = distance_squared(sharp->axis, broad->axis);

    sg_lobe product = *sharp;
    if (ratio > 0.0) {
        double sharpness = sharp->sharpness * size;
        /* two sharpnesses next to the largest double add to the largest double */
        product.sharpness = isinf(sharpness) && !isinf(sharp->sharpness) ? DBL_MAX : sharpness;
        if (size > 0.0)
            for (int i = 0; i < 3; i++)
                product.axis[i] = u[i] / size;
        else
            perpendicular(sharp->axis, product.axis);
        if (!(size > 0.0))
            product.sharpness = 0.0;
    }
    double factor = square > 0.0 ? exp(-broad->sharpness * (square / (size + 1.0 + ratio))) : 1.0;
    /* the larger amplitude first, so that it cannot overflow before the factor is in */
    int a_first = fabs(a->amplitude) >= fabs(b->amplitude);
    double large = a_first ? a->amplitude : b->amplitude;
    double small = a_first ? b->amplitude : a->amplitude;
    product.amplitude = large * factor * small;
    return product;
}

double sg_mean_from_sharpness(double lambda)
{
    if (!(lambda >= 0.0))
        return (double)NAN;
    if (isinf(lambda))
        return 1.0;
    sg_sharpness s = sg_sharpness_of(lambda);
    return s.odd / s.all;
}

/* Below mean(1) by Newton's method on mean(lambda) = r, from then on in p = 1/lambda on
 *     1 - mean = p - 2/(e^2lambda - 1),
 * because 1 - r is what r near 1 says exactly. */
double sg_sharpness_from_mean(double r)
{
    if (isnan(r))
        return r;
    if (r <= 0.0)
        return 0.0;
    if (r >= 1.0)
        return (double)INFINITY;
    double lambda = sg_sharpness_from_mean_banerjee(r);
    if (r < 0.31) {
        for (int i = 0; i < 6; i++) {
            double mean = sg_mean_from_sharpness(lambda);
            double slope = lambda > 1e-8 ? 1.0 - mean * (mean + 2.0 / lambda) : 1.0 / 3.0;
            double next = lambda + (r - mean) / slope;
            if (next == lambda)
                break;
            lambda = next;
        }
        return lambda;
    }
    double q = 1.0 - r, p = 1.0 / lambda;
    for (int i = 0; i < 8; i++) {
        double decay = exp(-2.0 / p), lit = -expm1(-2.0 / p);
        double slope = 1.0 - 4.0 * decay / (lit * lit * p * p);
        double next = p + (q - (p - 2.0 * decay / lit)) / slope;
        if (next == p)
            break;
        p = next;
    }
    return 1.0 / p;
}

double sg_mean_from_sharpness_toksvig(double lambda)
{
    if (!(lambda >= 0.0))
        return (double)NAN;
    return isinf(lambda) ? 1.0 : lambda / (1.0 + lambda);
}

double sg_sharpness_from_mean_toksvig(double r)
{
    if (isnan(r))
        return r;
    if (r <= 0.0)
        return 0.0;
    return r >= 1.0 ? (double)INFINITY : r / (1.0 - r);
}

/* The root in [0, 1] of r (3 + lambda r - r^2) = lambda, by Newton's method from the exact mean,
 * which it approximates. */
double sg_mean_from_sharpness_banerjee(double lambda)
{
    double r = sg_mean_from_sharpness(lambda);
    if (isinf(lambda) || lambda > 1e17)
        return 1.0;
    for (int i = 0; i < 6; i++) {
        double defect = r * (3.0 + r * (lambda - r)) - lambda;
        double next = r - defect / (3.0 + r * (2.0 * lambda - 3.0 * r));
        if (next == r)
            break;
        r = next;
    }
    return r;
}

double sg_sharpness_from_mean_banerjee(double r)
{
    if (isnan(r))
        return r;
    if (r <= 0.0)
        return 0.0;
    return r >= 1.0 ? (double)INFINITY : r * (3.0 - r * r) / ((1.0 - r) * (1.0 + r));
}

sg_lobe sg_lobe_from_moments(const double vector_sum[3], double weight_sum, sg_sharpness_rule rule,
                             double max_sharpness)
{
    sg_lobe lobe = {.axis = {0.0, 0.0, 1.0}};
    double size = length3(vector_sum);
    if (size > 0.0 && weight_sum > 0.0) {
        for (int i = 0; i < 3; i++)
            lobe.axis[i] = vector_sum[i] / size;
        lobe.sharpness = (rule ? rule : sg_sharpness_from_mean)(size / weight_sum);
        if (max_sharpness > 0.0 && lobe.sharpness > max_sharpness)
            lobe.sharpness = max_sharpness;
    }
    lobe.amplitude = weight_sum / sg_A(lobe.sharpness);
    return lobe;
}
