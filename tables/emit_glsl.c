/* emit_glsl.c: forms, methods and lobe operations as one GLSL include. */
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "emit.h"

static bool computes_L(const method *method)
{
    return strcmp(method->form->computes, "L") == 0;
}

static void method_functions(buffer *out, const method *method)
{
    bool L = computes_L(method);
    buffer name = {0};
    buffer_print(&name, "sg_%s_%s", L ? "L" : "A_h", method->id);
    buffer_add(out, "\n");
    comment_method(out, method);
    glsl_function(out, method->form, name.text, method->coefficients, "sg_");
    buffer_add(out, "\n");
    comment_other(out, method);
    if (L)
        buffer_print(out,
                     "float sg_A_h_%s(float lambda, float cos_theta)\n{\n"
                     "    return sg_A_h_from_L(%s(lambda, cos_theta), lambda);\n}\n",
                     method->id, name.text);
    else
        buffer_print(out,
                     "float sg_L_%s(float lambda, float cos_theta)\n{\n"
                     "    return sg_L_from_A_h(%s(lambda, cos_theta), lambda, cos_theta);\n}\n",
                     method->id, name.text);
    buffer_free(&name);
}

/* Marks what a method's two functions need. */
static bool mark_method(const form_list *forms, const method *method, bool *needed)
{
    const char *bridge = computes_L(method) ? "sg_A_h_from_L" : "sg_L_from_A_h";
    size_t helper = forms_helper(forms, bridge, strlen(bridge));
    if (helper == forms->helper_count) {
        base_error("expected the helper %s in shaders/forms/helpers", bridge);
        return false;
    }
    needed[helper] = true;
    forms_mark(forms, &forms->helpers[helper], needed);
    forms_mark(forms, method->form, needed);
    return true;
}

/* Plain GLSL with its method bound, helpers named by the prefix, those that it calls marked. The
 * comment lines before the first empty line speak to its editors and are left out. */
static bool plain_text(buffer *out, const form_list *forms, const char *path, const char *text,
                       const method *method, const char *prefix, bool *needed)
{
    static const char mark[] = "@METHOD@";
    buffer bound = {0};
    token *tokens = NULL;
    size_t count;
    int line = 1;
    for (; strncmp(text, "//", 2) == 0; line++) {
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    for (const char *next; method && (next = strstr(text, mark)); text = next + strlen(mark)) {
        buffer_add_n(&bound, text, (size_t)(next - text));
        buffer_add(&bound, method->id);
    }
    buffer_add(&bound, text);
    bool good = form_tokens(path, bound.text, line, &tokens, &count);
    for (size_t i = 0; good && i < count; i++) {
        const token *at = &tokens[i];
        size_t helper = at->kind == TOKEN_NAME ? forms_helper(forms, at->start, at->length)
                                               : forms->helper_count;
        if (helper == forms->helper_count) {
            buffer_add_n(out, at->start, at->length);
            continue;
        }
        buffer_print(out, "%s%.*s", prefix, (int)at->length - 3, at->start + 3);
        needed[helper] = true;
        forms_mark(forms, &forms->helpers[helper], needed);
    }
    free(tokens);
    buffer_free(&bound);
    return good;
}

static void write_helpers(buffer *out, const form_list *forms, const bool *needed,
                          const char *prefix)
{
    for (size_t i = 0; i < forms->helper_count; i++) {
        if (!needed[i])
            continue;
        buffer_add(out, "\n");
        comment_helper(out, &forms->helpers[i], prefix);
        glsl_function(out, &forms->helpers[i], NULL, NULL, prefix);
    }
}

static const char preface[] =
    "// sg.glsl: integrals of spherical Gaussians against the clamped cosine.\n"
    "// Written by `sgfit emit`; do not edit.\n"
    "//\n"
    "// To integrate: paste or #include this file after #version (450, 330, 300 es or later). It\n"
    "// defines functions and one struct, all named sg_, and the guard SG_GLSL; no binding, no\n"
    "// global, no other macro. In GLSL ES write `precision highp float;` before it: mediump is "
    "half\n"
    "// on many devices, for which none of the errors below hold. Then, per light:\n"
    "//\n"
    "//     irradiance += sg_irradiance(amplitude, axis, sharpness, normal);\n"
    "//\n"
    "// sg_irradiance calls sg_A_h_%s. Functions of one lobe of amplitude 1 take\n"
    "// (lambda, cos_theta): its sharpness and dot(axis, normal).\n"
    "//   A_h  integral of exp(lambda (dot(w, axis) - 1)) max(dot(w, normal), 0) over the sphere\n"
    "//   L    A_h over the integral of the lobe alone: the same for a lobe that integrates to 1\n"
    "//\n"
    "// Errors are of L against the integral over 400 sharpnesses, logarithmic on [1e-3, 1e4], "
    "times\n"
    "// 1001 angles beta, uniform on [0, pi], as far as they lie in the method's domain. Costs "
    "are\n"
    "// instructions that RADV needs for the function on navi21, without the shader around it.\n"
    "// Methods as published may fail at the ends of their domain; those named _stable are the "
    "same\n"
    "// models without that, and all others are stable too.\n"
    "//\n"
    "//   method                       max error  RMSE      A_h costs  what it is\n";

static void index_line(buffer *out, const method *method)
{
    buffer_print(out, "//   %-28s ", method->id);
    if (method->f32.given)
        buffer_print(out, "%-9.2e  %-9.2e ", method->f32.max_abs, method->f32.rmse);
    else
        buffer_print(out, "%-9s  %-9s ", "-", "-");
    buffer_print(out, "%-9s  %s\n", method->instructions ? method->instructions : "-",
                 method->title);
}

static void introduction(buffer *out, const method_list *methods, const method *only,
                         const method *irradiance)
{
    buffer_print(out, preface, irradiance->id);
    for (size_t i = 0; i < methods->count; i++) {
        if (!only || only == &methods->methods[i])
            index_line(out, &methods->methods[i]);
    }
    buffer_add(out, "#ifndef SG_GLSL\n#define SG_GLSL\n");
}

bool emit_glsl(buffer *out, const form_list *forms, const method_list *methods, const method *only,
               const char *lobe_path, const char *lobe, const method *irradiance)
{
    bool *needed = base_allocate(forms->helper_count + 1);
    memset(needed, 0, forms->helper_count + 1);
    buffer wrappers = {0};
    bool good = plain_text(&wrappers, forms, lobe_path, lobe, irradiance, "sg_", needed);
    for (size_t i = 0; good && i < methods->count; i++) {
        if (!only || only == &methods->methods[i])
            good = mark_method(forms, &methods->methods[i], needed);
    }
    if (good) {
        introduction(out, methods, only, irradiance);
        write_helpers(out, forms, needed, "sg_");
        for (size_t i = 0; i < methods->count; i++) {
            if (!only || only == &methods->methods[i])
                method_functions(out, &methods->methods[i]);
        }
        buffer_add(out, wrappers.text);
        buffer_add(out, "\n#endif\n");
    }
    buffer_free(&wrappers);
    free(needed);
    return good;
}

bool emit_table_glsl(buffer *out, const form_list *forms, const char *path, const char *text)
{
    bool *needed = base_allocate(forms->helper_count + 1);
    memset(needed, 0, forms->helper_count + 1);
    buffer body = {0};
    bool good = plain_text(&body, forms, path, text, NULL, "sg_table_", needed);
    if (good) {
        buffer_add(
            out,
            "// sg_table.glsl: the clamped-cosine integral of a spherical Gaussian from a "
            "look-up table.\n"
            "// Written by `sgfit emit`; do not edit.\n"
            "//\n"
            "// To integrate: include this file after #version (450, 330, 300 es or later), "
            "with sg.glsl or\n"
            "// without, and pass a sampler of tables/out/tail_32_half.exr or "
            "tail_32_float.exr as a\n"
            "// one-channel texture: 32 x 32, row 0 first, linear filter, clamped to edge, no "
            "mipmap. In GLSL\n"
            "// ES write `precision highp float;` before it; linear filtering of a float texture "
            "needs\n"
            "// OES_texture_float_linear there, of a half one nothing. tables/out/README.md states "
            "the errors.\n"
            "#ifndef SG_TABLE_GLSL\n#define SG_TABLE_GLSL\n");
        write_helpers(out, forms, needed, "sg_table_");
        buffer_add(out, body.text);
        buffer_add(out, "\n#endif\n");
    }
    buffer_free(&body);
    free(needed);
    return good;
}
