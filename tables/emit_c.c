/* emit_c.c: forms and methods as C. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "emit.h"

static const char generated[] =
    "/* Written by `sgfit emit` from shaders/forms and tables/constants: edit those. */\n";

static void function(buffer *out, const form *text)
{
    bool in_head = true;
    int depth = 0;
    for (const token *at = text->tokens; at->kind != TOKEN_END; at++) {
        switch (at->role) {
        case ROLE_REAL:
            buffer_add(out, "SG_REAL");
            break;
        case ROLE_LITERAL:
            buffer_add(out, "SG_K");
            break;
        case ROLE_PI:
            buffer_add(out, "SG_K(3.14159265358979323846)");
            break;
        case ROLE_COEFFICIENT:
            buffer_print(out, "sg_k[%zu]", at->index);
            break;
        case ROLE_BUILTIN:
            buffer_print(out, "SG_%.*s", (int)at->length, at->start);
            break;
        case ROLE_HELPER:
            buffer_print(out, "SG_NAME(%.*s)", (int)at->length, at->start);
            break;
        case ROLE_SELF:
            buffer_print(out, "SG_NAME(form_%s)", text->id);
            break;
        case ROLE_PLAIN:
            depth += token_is(at, "(");
            depth -= token_is(at, ")");
            if (in_head && depth == 0 && token_is(at, ")")) {
                in_head = false;
                if (!text->helper)
                    buffer_add(out, ", const SG_REAL *sg_k");
            }
            buffer_add_n(out, at->start, at->length);
            break;
        }
    }
}

/* In the double unit, where the text would only be accurate to float. */
static void stand_in(buffer *out, const form_list *forms, const form *helper)
{
    static const char *const names[] = {"x", "y", "z", "w"};
    const char *other = helper->c_double;
    bool known = forms_helper(forms, other, strlen(other)) < forms->helper_count;
    buffer_print(out, "SG_INLINE SG_REAL SG_NAME(%s)(", helper->id);
    for (size_t i = 0; i < helper->parameter_count && i < 4; i++)
        buffer_print(out, "%sSG_REAL %s", i ? ", " : "", names[i]);
    buffer_print(out, known ? ") { return SG_NAME(%s)(" : ") { return SG_%s(", other);
    for (size_t i = 0; i < helper->parameter_count && i < 4; i++)
        buffer_print(out, "%s%s", i ? ", " : "", names[i]);
    buffer_add(out, "); }\n");
}

void emit_forms_inc(buffer *out, const form_list *forms)
{
    buffer_add(out, generated);
    buffer_add(out, "#if defined(__GNUC__)\n#pragma GCC diagnostic push\n"
                    "#pragma GCC diagnostic ignored \"-Wunused\"\n"
                    "#pragma GCC diagnostic ignored \"-Wunused-parameter\"\n#endif\n");
    for (size_t i = 0; i < forms->helper_count; i++) {
        const form *helper = &forms->helpers[i];
        buffer_print(out, "\n// %s: %s\n", helper->id, helper->about);
        if (helper->c_double) {
            buffer_add(out, "#if SG_PRECISION >= 64\n");
            stand_in(out, forms, helper);
            buffer_add(out, "#else\n");
        }
        buffer_add(out, "SG_INLINE ");
        function(out, helper);
        if (helper->c_double)
            buffer_add(out, "#endif\n");
    }
    for (size_t i = 0; i < forms->form_count; i++) {
        const form *text = &forms->forms[i];
        buffer_print(out, "\n// %s: %s\nSG_INLINE ", text->id, text->about);
        function(out, text);
    }
    buffer_add(out, "\n#if defined(__GNUC__)\n#pragma GCC diagnostic pop\n#endif\n");
}

void emit_methods_inc(buffer *out, const method_list *methods)
{
    buffer_add(out, generated);
    for (size_t i = 0; i < methods->count; i++) {
        const method *method = &methods->methods[i];
        char number[BASE_NUMBER_SIZE];
        buffer_print(out, "SG_METHOD(%s, %s, %s", method->id, method->form->id,
                     method->form->computes);
        for (size_t j = 0; j < method->form->coefficient_count; j++)
            buffer_print(out, ", SG_K(%s)", base_shortest_f64(method->coefficients[j], number));
        buffer_print(out, "%s)\n", method->form->coefficient_count ? "" : ", SG_K(0.0)");
    }
}

static void quoted(buffer *out, const char *text)
{
    buffer_add(out, "\"");
    for (; *text; text++) {
        if (*text == '"' || *text == '\\' || *text == '?')
            buffer_add(out, "\\");
        buffer_add_n(out, text, 1);
    }
    buffer_add(out, "\"");
}

void emit_registry_inc(buffer *out, const form_list *forms, const method_list *methods)
{
    char number[BASE_NUMBER_SIZE];
    buffer_add(out, generated);
    for (size_t i = 0; i < forms->form_count; i++) {
        const form *text = &forms->forms[i];
        buffer_print(out, "SG_FORM_ROW(%s, %s, %zu", text->id, text->computes,
                     text->coefficient_count);
        for (size_t j = 0; j < text->coefficient_count; j++)
            buffer_print(out, ", \"%s\"", text->coefficients[j]);
        buffer_print(out, "%s)\n", text->coefficient_count ? "" : ", NULL");
    }
    for (size_t i = 0; i < methods->count; i++) {
        const method *method = &methods->methods[i];
        buffer_print(out, "SG_METHOD_ROW(%s, %s,\n    ", method->id, method->form->id);
        quoted(out, method->title);
        buffer_add(out, ",\n    ");
        quoted(out, method->source);
        buffer_print(out, ",\n    %d, \"%s\", %s, ", method->year, method->variant,
                     base_shortest_f64(method->lambda_min, number));
        buffer_print(out, "%s)\n",
                     isinf(method->lambda_max) ? "(double)INFINITY"
                                               : base_shortest_f64(method->lambda_max, number));
    }
}
