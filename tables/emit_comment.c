/* emit_comment.c: what stands above a function in GLSL. */
#include <math.h>
#include <string.h>

#include "emit.h"

enum { WIDTH = 100 };

static void error_line(buffer *out, const char *precision, const measured *errors)
{
    if (!errors->given)
        return;
    double cosine = cos(errors->max_abs_beta);
    if (!isfinite(errors->max_abs)) {
        buffer_print(out, "//   %-7s not finite, first at lambda %.4g, beta %.4g\n", precision,
                     errors->max_abs_lambda, errors->max_abs_beta);
        return;
    }
    buffer_print(out, "//   %-7s max %.3g at lambda %.4g, beta %.4g (cos_theta %.4g); RMSE %.3g\n",
                 precision, errors->max_abs, errors->max_abs_lambda, errors->max_abs_beta,
                 fabs(cosine) < 1e-9 ? 0.0 : cosine, errors->rmse);
}

/* A text's first line and its notes as one paragraph. */
static void paragraph(buffer *out, const char *first, const form *text)
{
    buffer line = {0};
    buffer_print(&line, "%s%s ", first, text->about);
    for (const char *note = text->notes; *note; note++)
        buffer_add_n(&line, *note == '\n' ? " " : note, 1);
    buffer_wrap(out, "// ", "// ", line.text, WIDTH);
    buffer_free(&line);
}

void comment_helper(buffer *out, const form *helper, const char *prefix)
{
    buffer name = {0};
    buffer_print(&name, "%s%s: ", prefix, helper->id + strlen("sg_"));
    paragraph(out, name.text, helper);
    buffer_free(&name);
    if (helper->source)
        buffer_wrap(out, "// Source: ", "//   ", helper->source, WIDTH);
}

static bool computes_L(const method *method)
{
    return strcmp(method->form->computes, "L") == 0;
}

static void returns(buffer *out, const method *method, bool L)
{
    if (L)
        buffer_print(out, "// sg_L_%s returns L, in [0, 1] up to its error.\n", method->id);
    else
        buffer_print(out,
                     "// sg_A_h_%s returns A_h, in [0, pi] up to its error, which is that of L "
                     "times\n// sg_integral(lambda).\n",
                     method->id);
}

void comment_method(buffer *out, const method *method)
{
    buffer line = {0};
    buffer_print(&line, "%s: %s (%s, %d).", method->id, method->title, method->variant,
                 method->year);
    buffer_wrap(out, "// ", "//   ", line.text, WIDTH);
    buffer_free(&line);
    returns(out, method, computes_L(method));
    buffer_print(out, "// Domain: lambda in [%.6g, %.6g%s, cos_theta in [-1, 1].\n",
                 method->lambda_min, method->lambda_max, isinf(method->lambda_max) ? ")" : "]");
    if (method->f32.given || method->f64.given)
        buffer_add(out, "// Error of L:\n");
    error_line(out, "float", &method->f32);
    error_line(out, "double", &method->f64);
    if (method->cost)
        buffer_wrap(out, "// Cost on navi21: ", "//   ", method->cost, WIDTH);
    buffer_wrap(out, "// Source: ", "//   ", method->source, WIDTH);
    if (method->command)
        buffer_wrap(out, "// Made by: ", "//   ", method->command, WIDTH);
    buffer form = {0};
    buffer_print(&form, "Form %s: ", method->form->id);
    paragraph(out, form.text, method->form);
    buffer_free(&form);
}

void comment_other(buffer *out, const method *method)
{
    returns(out, method, !computes_L(method));
    buffer_add(out, "// Domain, error and source: above.\n");
}
