/* glsl_function.c: the function of one text as GLSL. */
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
void glsl_function(buffer *out, const form *text, const char *name, const double *coefficients,
                   const char *prefix)
{
    bool opened = false;
    for (const token *at = text->tokens; at->kind != TOKEN_END; at++) {
        if (at->role == ROLE_REAL)
            buffer_add(out, "float");
        else if (at->role == ROLE_SELF)
            buffer_add(out, name);
        else if (at->role == ROLE_HELPER)
            buffer_print(out, "%s%.*s", prefix, (int)at->length - 3, at->start + 3);
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
