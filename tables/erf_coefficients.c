/* erf_coefficients.c: where the numbers in shaders/forms/helpers/sg_erf.glsl and sg_erfc.glsl
 * come from. Not part of the program; build and run it alone:
 *
 *     cc -o erf_coefficients tables/erf_coefficients.c -lm && ./erf_coefficients
 *
 * Both are Chebyshev interpolations, in long double, rewritten in powers:
 *   erf(x)/x                     in q = 2 x^2 - 1,             x in [0, 1]
 *   (x + a) exp(x^2) erfc(x)     in y = 1 - 2a/(x + a),        x in [0, inf)
 * The variables are centred so that the powers do not cancel in float. Each line also prints the
 * largest relative error of the interpolation itself. */
#include <math.h>
#include <stdio.h>

enum { DEGREE_MAX = 20 };
static const long double pi = 3.14159265358979323846264338327950288L;
static const long double shift = 2.5L; /* a */

static long double erf_over_x(long double q)
{
    long double x = sqrtl((q + 1.0L) / 2.0L);
    return x < 1e-9L ? 2.0L / sqrtl(pi) : erfl(x) / x;
}

static long double scaled_erfc(long double y)
{
    long double x = shift * (1.0L + y) / (1.0L - y);
    if (x < 40.0L)
        return (x + shift) * expl(x * x) * erfcl(x);
    /* asymptotic series; its terms fall to 1e-26 before they grow again */
    long double sum = 1.0L, term = 1.0L;
    for (int k = 1; k < 12; k++) {
        term *= -(2.0L * (long double)k - 1.0L) / (2.0L * x * x);
        sum += term;
    }
    return sum * (1.0L + shift / x) / sqrtl(pi);
}

/* Chebyshev interpolation of f on [-1, 1]; coefficients of 1, v, v^2 ... */
static void interpolate(long double (*f)(long double), int degree, long double *powers)
{
    int n = degree + 1;
    long double series[DEGREE_MAX + 1], before[DEGREE_MAX + 2] = {1.0L};
    long double now[DEGREE_MAX + 2] = {0.0L, 1.0L};
    for (int k = 0; k < n; k++) {
        series[k] = 0.0L;
        for (int i = 0; i < n; i++) {
            long double angle = pi * ((long double)i + 0.5L) / (long double)n;
            series[k] += f(cosl(angle)) * cosl((long double)k * angle);
        }
        series[k] *= (k ? 2.0L : 1.0L) / (long double)n;
    }
    for (int j = 0; j < n; j++)
        powers[j] = (j == 0 ? series[0] : 0.0L) + (degree > 0 && j == 1 ? series[1] : 0.0L);
    for (int k = 2; k < n; k++) {
        long double next[DEGREE_MAX + 2] = {0.0L};
        for (int j = 0; j < n; j++)
            next[j] = (j ? 2.0L * now[j - 1] : 0.0L) - before[j];
        for (int j = 0; j < n; j++) {
            powers[j] += series[k] * next[j];
            before[j] = now[j];
            now[j] = next[j];
        }
    }
}

static void print(const char *name, long double (*f)(long double), int degree)
{
    long double powers[DEGREE_MAX + 1], worst = 0.0L;
    interpolate(f, degree, powers);
    for (int i = 0; i < 20000; i++) {
        long double v = -1.0L + 2.0L * (long double)i / 20000.0L, sum = powers[degree];
        for (int j = degree - 1; j >= 0; j--)
            sum = sum * v + powers[j];
        worst = fmaxl(worst, fabsl(sum / f(v) - 1.0L));
    }
    printf("%s, degree %d, relative error %.1Le\n", name, degree, worst);
    for (int j = 0; j <= degree; j++)
        printf("    %.12Lg\n", powers[j]);
}

int main(void)
{
    print("erf(x)/x in 2x^2 - 1", erf_over_x, 6);
    print("(x + a) exp(x^2) erfc(x) in 1 - 2a/(x + a)", scaled_erfc, 10);
    return 0;
}
