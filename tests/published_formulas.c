/* Sources: Meder and Bruederlin 2018 (Screen Space Approximate Gaussian Hulls), Meder and
 * Bruederlin 2018 (Hemispherical Gaussians), Pettineo and Hill 2016, Tokuyoshi 2022, Tokuyoshi
 * et al. 2024 (supplement). */
#include "published_formulas.h"

#include <math.h>

static const long double pi = 3.14159265358979323846264338327950288L;

/* (1 - e^-x)/x */
static long double falling(long double x)
{
    return x == 0.0L ? 1.0L : -expm1l(-x) / x;
}

static long double integral(long double lambda)
{
    return 4.0L * pi * falling(2.0L * lambda);
}

/* (e^x - 1 - x)/x^2 */
static long double second_order(long double x)
{
    if (fabsl(x) > 0.5L)
        return (expl(x) - 1.0L - x) / (x * x);
    long double sum = 0.0L, term = 0.5L;
    for (int k = 3; fabsl(term) > 1e-22L; k++) {
        sum += term;
        term *= x / (long double)k;
    }
    return sum;
}

static long double upper(long double lambda)
{
    return 2.0L * pi * second_order(-lambda);
}

static long double lower(long double lambda)
{
    if (lambda < 0.5L)
        return 2.0L * pi * expl(-2.0L * lambda) * second_order(lambda);
    return 2.0L * pi * (expl(-lambda) - (1.0L + lambda) * expl(-2.0L * lambda)) / (lambda * lambda);
}

static long double clamped(long double z)
{
    return z > 0.0L ? z : 0.0L;
}

static long double constant_cosine(long double lambda, long double z)
{
    (void)lambda;
    return clamped(z);
}

/* |a v + b n| and the exponent |a v + b n| - a, which is what is left of the product's amplitude
 * times e^b. */
static long double product(long double a, long double b, long double z, long double *exponent)
{
    long double sharpness = hypotl(a - b, sqrtl(2.0L * a * b * (1.0L + z)));
    *exponent = b * (2.0L * a * z + b) / (sharpness + a);
    return sharpness;
}

static long double lobe_product(long double lambda, long double z, long double amplitude,
                                long double sharpness)
{
    long double exponent, both = product(lambda, sharpness, z, &exponent);
    return amplitude * expl(exponent - sharpness) * integral(both) / integral(lambda);
}

static long double tokuyoshi_2016(long double lambda, long double z)
{
    return lobe_product(lambda, z, 1.0L, 2.0L);
}

static long double wang_2009(long double lambda, long double z)
{
    return lobe_product(lambda, z, 1.17L, 2.133L);
}

static long double pettineo_hill_2016(long double lambda, long double z)
{
    long double c0 = 0.36L, c1 = 0.25L / c0, e = expl(-lambda);
    long double scale = 1.0L + 2.0L * e * e - 1.0L / lambda;
    long double bias = (e - e * e) / lambda - e * e;
    long double x = sqrtl(1.0L / lambda - 2.0L * e * e), x0 = c0 * z, x1 = c1 * x;
    long double y = fabsl(x0) <= x1 ? (x0 + x1) * (x0 + x1) / x : clamped(z);
    return (scale * y + bias) * 2.0L * pi / lambda / integral(lambda);
}

static long double meder_2018(long double lambda, long double z)
{
    long double t = 2.1007L * sqrtl(lambda) * lambda / (lambda + 4.4653L);
    long double s = 1.0L / (0.2958L * t + 0.5033L) / (expl(fabsl(z) * t) + 1.0L);
    long double c = s * (0.5L * z + 0.5L) + (1.0L - s) * clamped(z);
    return (c * upper(lambda) + (1.0L - c) * lower(lambda)) / integral(lambda);
}

/* H = (A_upper + A_lower)/2 + R (A_upper - A_lower)/2, R = 2s - 1 in [-1, 1]. */
static long double hemisphere(long double lambda, long double R)
{
    long double above = 2.0L * pi * falling(lambda), below = expl(-lambda) * above;
    return 0.5L * (above + below + R * (above - below));
}

static long double logistic_R(long double lambda, long double z)
{
    long double t = sqrtl(lambda) * (1.6988L * lambda * lambda + 10.8438L * lambda) /
                    (lambda * lambda + 6.2201L * lambda + 10.2415L);
    return tanhl(0.5L * t * z) / tanhl(0.5L * t);
}

static long double meder_2018_hg(long double lambda, long double z)
{
    long double b = 0.0315L, exponent, both = product(lambda, b, z, &exponent);
    long double lit =
        32.708L * expl(exponent - b) * hemisphere(both, logistic_R(both, (lambda * z + b) / both));
    return (lit - 31.7003L * hemisphere(lambda, logistic_R(lambda, z))) / integral(lambda);
}

static long double erf_R(long double lambda, long double z)
{
    long double t =
        lambda * sqrtl((0.5L * lambda + 0.65173288269070562L) /
                       (lambda * lambda + 1.3418280033141288L * lambda + 7.2216687798956709L));
    return erfl(t * z) / erfl(t);
}

static long double tokuyoshi_2022(long double lambda, long double z)
{
    long double b = 0.00084560872241480124L, exponent, both = product(lambda, b, z, &exponent);
    long double alpha = 0.5L / (b * second_order(b));
    long double p = expl(exponent) * hemisphere(both, erf_R(both, (lambda * z + b) / both));
    long double value = alpha * (p - hemisphere(lambda, erf_R(lambda, z))) / integral(lambda);
    return clamped(value);
}

static long double tokuyoshi_2024(long double lambda, long double z)
{
    long double above = lambda * lambda + 2.7360831611272558L * lambda + 17.021297781741876L;
    long double below = ((lambda + 4.0100826728510421L) * lambda + 15.219156263147211L) * lambda +
                        76.087896272360737L;
    long double t = lambda * sqrtl(0.5L * above / below);
    long double s = 0.5L * (z * erfcl(-t * z) + erfcl(t)) -
                    expl(-t * t * z * z) * expm1l(t * t * (z * z - 1.0L)) / (2.0L * t * sqrtl(pi));
    return (lower(lambda) + s * (upper(lambda) - lower(lambda))) / integral(lambda);
}

const published_formula published_formulas[] = {{"constant_cosine", constant_cosine, 0.0L},
                                                {"tokuyoshi_2016", tokuyoshi_2016, 0.0L},
                                                {"wang_2009", wang_2009, 0.0L},
                                                {"pettineo_hill_2016", pettineo_hill_2016, 1.0L},
                                                {"meder_2018", meder_2018, 0.0L},
                                                {"meder_2018_hg", meder_2018_hg, 0.0L},
                                                {"tokuyoshi_2022", tokuyoshi_2022, 0.0L},
                                                {"tokuyoshi_2024", tokuyoshi_2024, 0.0L}};
const size_t published_formula_count = sizeof published_formulas / sizeof published_formulas[0];
