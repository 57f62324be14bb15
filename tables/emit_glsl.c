/* emit_glsl.c: forms, methods and lobe operations as one GLSL include. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "emit.h"

static void number(buffer *out, double value)
{
    char text[BASE_NUMBER_SIZE];
    base_shortest_f64(value, text);
    buffer_print(out, "%s%s", text, strpbrk(text, ".e") ? "" : ".0");
}

/* K(1.5) from its opening parenthesis on: 1.5. A sign goes into parentheses where another operator
 * may stand before it: a - K(-1.5). Returns the closing parenthesis. */
static const token *literal(buffer *out, const token *at)
{
    size_t last = out->length;
    while (last > 0 && out->text[last - 1] == ' ')
        last--;
    bool bare = last > 0 && strchr("(,=?:", out->text[last - 1]), negative = false;
    for (; !token_is(at, ")"); at++) {
        if (token_is(at, "-")) {
            negative = true;
            buffer_add(out, bare ? "-" : "(-");
        } else if (at->kind == TOKEN_NUMBER) {
            buffer_add_n(out, at->start, at->length);
        }
    }
    if (negative && !bare)
        buffer_add(out, ")");
    return at;
}

/* The function of a text as GLSL: `name` instead of sg_form, the coefficients as local constants.
 */
static void function(buffer *out, const form *text, const char *name, const double *coefficients)
{
    bool opened = false;
    for (const token *at = text->tokens; at->kind != TOKEN_END; at++) {
        if (at->role == ROLE_REAL)
            buffer_add(out, "float");
        else if (at->role == ROLE_SELF)
            buffer_add(out, name);
        else if (at->role == ROLE_LITERAL)
            at = literal(out, at);
        else
            buffer_add_n(out, at->start, at->length);
        if (opened || !token_is(at, "{"))
            continue;
        opened = true;
        if (text->uses_pi)
            buffer_add(out, "\n    const float sg_pi = 3.14159265358979;");
        for (size_t i = 0; i < text->coefficient_count; i++) {
            buffer_print(out, "\n    const float %s = ", text->coefficients[i]);
            number(out, coefficients[i]);
            buffer_add(out, ";");
        }
    }
}

static void helper_comment(buffer *out, const form *helper)
{
    buffer line = {0};
    buffer_print(&line, "%s: %s", helper->id, helper->about);
    buffer_wrap(out, "\n// ", "// ", line.text, 100);
    buffer_free(&line);
    for (const char *note = helper->notes; *note;) {
        size_t length = strcspn(note, "\n");
        buffer_print(out, "//%s%.*s\n", length ? " " : "", (int)length, note);
        note += length + 1;
    }
    if (helper->source)
        buffer_wrap(out, "// Source: ", "//   ", helper->source, 100);
}

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
    emit_method_comment(out, method);
    function(out, method->form, name.text, method->coefficients);
    if (L)
        buffer_print(out,
                     "\nfloat sg_A_h_%s(float lambda, float cos_theta)\n{\n"
                     "    return sg_A_h_from_L(%s(lambda, cos_theta), lambda);\n}\n",
                     method->id, name.text);
    else
        buffer_print(out,
                     "\nfloat sg_L_%s(float lambda, float cos_theta)\n{\n"
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

/* The lobe text with its method bound, and the helpers that it calls marked. The comment lines
 * before the first empty line speak to its editors and are left out. */
static bool lobe_text(buffer *out, const form_list *forms, const char *path, const char *text,
                      const method *method, bool *needed)
{
    static const char mark[] = "@METHOD@";
    token *tokens;
    size_t count;
    while (strncmp(text, "//", 2) == 0) {
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    for (const char *next; (next = strstr(text, mark)); text = next + strlen(mark)) {
        buffer_add_n(out, text, (size_t)(next - text));
        buffer_add(out, method->id);
    }
    buffer_add(out, text);
    bool good = form_tokens(path, out->text, 1, &tokens, &count);
    for (size_t i = 0; good && i < count; i++) {
        size_t helper = forms_helper(forms, tokens[i].start, tokens[i].length);
        if (tokens[i].kind == TOKEN_NAME && helper < forms->helper_count) {
            needed[helper] = true;
            forms_mark(forms, &forms->helpers[helper], needed);
        }
    }
    free(tokens);
    return good;
}

static void introduction(buffer *out, const method_list *methods, const method *only,
                         const method *irradiance)
{
    buffer_add(
        out, "// sg.glsl: integrals of spherical Gaussians against the clamped cosine.\n"
             "// Written by `sgfit emit`; do not edit.\n"
             "//\n"
             "// To integrate: paste or #include this file after #version (450, 330, 300 es or "
             "later). It\n"
             "// defines functions and one struct, all named sg_, and the guard SG_GLSL; no "
             "binding, no\n"
             "// global, no other macro. In GLSL ES write `precision highp float;` before it: "
             "mediump is\n"
             "// half on many devices, for which none of the errors below hold. Then, per light:\n"
             "//\n");
    buffer_print(out,
                 "//     irradiance += sg_irradiance(amplitude, axis, sharpness, normal);\n//\n"
                 "// sg_irradiance calls sg_A_h_%s. Functions of one lobe of amplitude 1 take\n"
                 "// (lambda, cos_theta): sharpness and dot(axis, normal).\n"
                 "//   A_h  integral of exp(lambda (dot(w, axis) - 1)) max(dot(w, normal), 0) over "
                 "the sphere\n"
                 "//   L    A_h over the integral of the lobe alone: the same for a lobe that "
                 "integrates to 1\n"
                 "//\n// Methods, and the largest error of L in float:\n",
                 irradiance->id);
    for (size_t i = 0; i < methods->count; i++) {
        const method *method = &methods->methods[i];
        if (only && only != method && irradiance != method)
            continue;
        buffer_print(out, "//   %-28s ", method->id);
        if (method->f32.given)
            buffer_print(out, "%-9.3g ", method->f32.max_abs);
        else
            buffer_add(out, "          ");
        buffer_print(out, "%s\n", method->title);
    }
    buffer_add(out, "#ifndef SG_GLSL\n#define SG_GLSL\n");
}

bool emit_glsl(buffer *out, const form_list *forms, const method_list *methods, const method *only,
               const char *lobe_path, const char *lobe, const method *irradiance)
{
    bool *needed = tables_allocate(forms->helper_count + 1);
    memset(needed, 0, forms->helper_count + 1);
    buffer wrappers = {0};
    bool good = lobe_text(&wrappers, forms, lobe_path, lobe, irradiance, needed);
    for (size_t i = 0; good && i < methods->count; i++) {
        if (!only || only == &methods->methods[i])
            good = mark_method(forms, &methods->methods[i], needed);
    }
    if (good) {
        introduction(out, methods, only, irradiance);
        for (size_t i = 0; i < forms->helper_count; i++) {
            if (needed[i]) {
                helper_comment(out, &forms->helpers[i]);
                function(out, &forms->helpers[i], NULL, NULL);
            }
        }
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
