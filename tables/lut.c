/* lut.c: the fitted tail as EXR, half and float, and the page that describes tables/out. */
#include "lut.h"

#include <math.h>

#include "base/exr.h"
#include "sg.h"
#include "tail.h"

enum { TEXELS = TAIL_SIZE * TAIL_SIZE };

static const char content[] = "T sqrt(lambda + 2), T(lambda, c) = L(lambda, -c), c = |cos_theta|; "
                              "L(lambda, z) = (coth lambda - 1/lambda) max(z, 0) + T(lambda, |z|)";
static const char mapping[] =
    "texel (i, j), i along x, j along y, stands at u = lambda/(lambda + 2) = i/31, "
    "v = c sqrt(lambda + 2)/4.5 = j/31";
static const char lookup[] = "bilinear at texture coordinates ((31 u + 0.5)/32, (31 v + 0.5)/32), "
                             "u and v clamped to [0, 1]; row 0 first";
static const char fitted[] =
    "texels are fitted to make the largest error of L in the bilinear look-up small; they are not "
    "the function's values at their places";

/* The nearest half, as double. */
static double to_half(double x)
{
    int exponent;
    frexp(x, &exponent);
    double unit = ldexp(1.0, (exponent < -13 ? -13 : exponent) - 11);
    return rint(x / unit) * unit;
}

typedef struct errors {
    double max, max_lambda, max_beta, rmse;
} errors;

/* On the project's grid: 400 sharpnesses, logarithmic on [1e-3, 1e4], 1001 angles uniform on
 * [0, pi]. The odd part is exact, so that one half of the angles stands for both. */
static errors measure(const double *texels)
{
    enum { SHARPNESSES = 400, ANGLES = 501 };
    const double pi = 3.14159265358979323846;
    errors found = {0};
    double lambda[ANGLES], z[ANGLES], L[ANGLES], sum = 0;
    for (int i = 0; i < SHARPNESSES; i++) {
        for (int j = 0; j < ANGLES; j++) {
            lambda[j] = pow(10, -3 + 7.0 * i / (SHARPNESSES - 1));
            z[j] = -cos(pi * j / (2 * (ANGLES - 1)));
        }
        sg_L_cos_batch(ANGLES, lambda, z, L);
        for (int j = 0; j < ANGLES; j++) {
            double error = fabs(tail_lookup(texels, lambda[j], -z[j]) - L[j]);
            sum += (j == ANGLES - 1 ? 1 : 2) * error * error;
            if (error > found.max) {
                found.max = error;
                found.max_lambda = lambda[j];
                found.max_beta = pi - pi * j / (2 * (ANGLES - 1));
            }
        }
    }
    found.rmse = sqrt(sum / (SHARPNESSES * (2.0 * ANGLES - 1)));
    return found;
}

static void describe(buffer *out, const char *name, const double *texels)
{
    errors found = measure(texels);
    buffer_print(out, "| `%s` | %.2e at (%.3g, %.3g) | %.1e |\n", name, found.max, found.max_lambda,
                 found.max_beta, found.rmse);
}

static void readme(buffer *out, const double *as_float, const double *as_half)
{
    buffer_add(
        out,
        "# What is here\n\nWritten by `sgfit emit`; do not edit.\n\n"
        "- `forms.inc`, `methods.inc`, `registry.inc`: what libsg compiles of `shaders/forms` and "
        "`tables/constants`. Equal to\n  the byte on every machine. Where a build stops at one of "
        "them: `git checkout tables/out`, "
        "build, correct the form,\n  `sgfit emit`.\n"
        "- `curves_c_s.csv`: Meder's c and s over lambda and beta (radians), ten "
        "decimals.\n"
        "- `curves_t_u.csv`: for each lambda the t and u with which `u/(exp(t |cos beta|) + 1)` "
        "follows s best: unweighted\n  least squares over 401 values of `|cos beta|`, uniform from "
        "0 to `min(1, 6/sqrt(lambda + 2))`; seven digits.\n"
        "- `tail_32_float.exr`, `tail_32_half.exr`: the look-up table that `shaders/sg_table.glsl` "
        "reads, one channel Y,\n  32 x 32, uncompressed.\n"
        "- `chart.svg`, `box_*.png`: pictures of the project's README, by `sgfit report "
        "--readme`.\n\n"
        "Another machine's mathematical library may change the last digits: c and s by 2e-10, t "
        "and u by a relative 2e-6,\ntexels by 2e-6 (float) and one unit in the last place "
        "(half).\n\n"
        "## The look-up table\n\n");
    buffer_print(out, "- Content: %s.\n- Mapping: %s.\n- Look-up: %s.\n- Note: %s.\n\n", content,
                 mapping, lookup, fitted);
    buffer_add(out, "Errors of L over 400 sharpnesses, logarithmic on [1e-3, 1e4], times 1001 "
                    "angles, uniform on [0, pi]:\n\n"
                    "| file | max, at (lambda, beta) | RMSE |\n| --- | --- | --- |\n");
    describe(out, "tail_32_float.exr", as_float);
    describe(out, "tail_32_half.exr", as_half);
}

bool lut_make(lut *made)
{
    static const exr_text attributes[] = {
        {"content", content}, {"mapping", mapping}, {"lookup", lookup}, {"note", fitted}};
    enum { ATTRIBUTES = sizeof attributes / sizeof attributes[0] };
    double texels[TEXELS], halves[TEXELS];
    float pixels[TEXELS];
    *made = (lut){{0}, {0}, {0}};
    tail_fit(texels);
    for (int i = 0; i < TEXELS; i++) {
        /* Rounded where another machine's last digits do not show. */
        pixels[i] = (float)(rint(texels[i] * 1e6) / 1e6);
        texels[i] = (double)pixels[i];
        halves[i] = to_half(texels[i]);
    }
    readme(&made->readme, texels, halves);
    const exr_channel channel = {.name = "Y", .pixels = pixels};
    exr_image image = {TAIL_SIZE, TAIL_SIZE, &channel, 1, false, false, attributes, ATTRIBUTES};
    bool good = exr_encode(&made->float_exr, &image);
    image.half = true;
    return good && exr_encode(&made->half_exr, &image);
}

void lut_free(lut *made)
{
    buffer_free(&made->float_exr);
    buffer_free(&made->half_exr);
    buffer_free(&made->readme);
}
