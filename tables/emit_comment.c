/* emit_comment.c: what stands above a method in GLSL. */
#include <math.h>
#include <string.h>

#include "emit.h"

enum { WIDTH = 100 };

static void error_line(buffer *out, const char *precision, const measured *errors)
{
    if (!errors->given)
        return;
    double cosine = cos(errors->max_abs_beta);
    buffer_print(out, "//   %-7s max %.3g at lambda %.4g, beta %.4g (cos_theta %.4g); RMSE %.3g\n",
                 precision, errors->max_abs, errors->max_abs_lambda, errors->max_abs_beta,
                 fabs(cosine) < 1e-9 ? 0.0 : cosine, errors->rmse);
}

void emit_method_comment(buffer *out, const method *method)
{
    buffer line = {0};
    buffer_print(&line, "%s: %s (%s, %d).", method->id, method->title, method->variant,
                 method->year);
    buffer_wrap(out, "// ", "//   ", line.text, WIDTH);
    buffer_free(&line);
    buffer_add(out, "// Returns L, in [0, 1], and A_h, in [0, pi], but for the errors below.\n");
    buffer_print(out, "// Domain: lambda in [%.6g, %.6g%s, cos_theta in [-1, 1].\n",
                 method->lambda_min, method->lambda_max, isinf(method->lambda_max) ? ")" : "]");
    if (method->f32.given || method->f64.given)
        buffer_add(out, "// Error of L against the integral:\n");
    error_line(out, "float", &method->f32);
    error_line(out, "double", &method->f64);
    if (method->cost)
        buffer_wrap(out, "// Cost: ", "//   ", method->cost, WIDTH);
    buffer_wrap(out, "// Source: ", "//   ", method->source, WIDTH);
    if (method->command)
        buffer_wrap(out, "// Made by: ", "//   ", method->command, WIDTH);
}
