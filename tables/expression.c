/* expression.c: recursive descent through the expressions of a form or helper text. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "parse.h"

static const struct {
    const char *name;
    size_t parameters;
} builtins[] = {{"exp", 1},   {"exp2", 1},        {"log", 1}, {"log2", 1}, {"sqrt", 1},
                {"abs", 1},   {"inversesqrt", 1}, {"min", 2}, {"max", 2},  {"clamp", 3},
                {"floor", 1}, {"sign", 1},        {"pow", 2}};

void parse_skip(parser *p)
{
    while (p->at->kind == TOKEN_BLANK)
        p->at++;
}

void parse_next(parser *p)
{
    p->at++;
    parse_skip(p);
}

bool parse_refuse(const parser *p, const token *at, const char *expected)
{
    if (at->kind == TOKEN_END)
        base_error("%s:%d: expected %s, found the end of the file", p->text->path, at->line,
                   expected);
    else
        base_error("%s:%d: expected %s, found '%.*s'", p->text->path, at->line, expected,
                   (int)at->length, at->start);
    return false;
}

bool parse_take(parser *p, const char *sign)
{
    if (!token_is(p->at, sign)) {
        char expected[16] = "'";
        strcat(strcat(expected, sign), "'");
        return parse_refuse(p, p->at, expected);
    }
    parse_next(p);
    return true;
}

static bool same(const token *a, const char *text, size_t length)
{
    return a->length == length && memcmp(a->start, text, length) == 0;
}

const variable *parse_variable(const parser *p, const token *name)
{
    for (size_t i = 0; i < p->variable_count; i++) {
        if (same(name, p->variables[i].name->start, p->variables[i].name->length))
            return &p->variables[i];
    }
    return NULL;
}

bool parse_coefficient(const parser *p, const token *name, size_t *index)
{
    for (size_t i = 0; i < p->text->coefficient_count; i++) {
        const char *coefficient = p->text->coefficients[i];
        if (same(name, coefficient, strlen(coefficient))) {
            *index = i;
            return true;
        }
    }
    return false;
}

bool parse_builtin(const token *name, size_t *parameters)
{
    for (size_t i = 0; i < sizeof builtins / sizeof builtins[0]; i++) {
        if (token_is(name, builtins[i].name)) {
            *parameters = builtins[i].parameters;
            return true;
        }
    }
    return false;
}

/* K(1.5): the only place for a literal. GLSL ES has no implicit conversions and C would divide
 * integers, so it needs a point or an exponent; float has to be able to hold it. */
static type literal(parser *p)
{
    p->at->role = ROLE_LITERAL;
    parse_next(p);
    if (!parse_take(p, "("))
        return TYPE_ERROR;
    if (token_is(p->at, "-"))
        parse_next(p);
    const token *number = p->at;
    double value;
    if (number->kind != TOKEN_NUMBER || !base_parse_f64(number->start, number->length, &value) ||
        (!memchr(number->start, '.', number->length) &&
         !memchr(number->start, 'e', number->length)) ||
        memchr(number->start, 'x', number->length)) {
        parse_refuse(p, number, "a literal with a point or an exponent, as in K(1.5)");
        return TYPE_ERROR;
    }
    if (value != 0 && (value > (double)FLT_MAX || value < (double)FLT_MIN)) {
        parse_refuse(p, number, "a literal that float can hold");
        return TYPE_ERROR;
    }
    parse_next(p);
    return parse_take(p, ")") ? TYPE_REAL : TYPE_ERROR;
}

static type call(parser *p)
{
    token *name = p->at;
    size_t parameters = 0, given = 0, helper = forms_helper(p->list, name->start, name->length);
    bool known = helper < p->list->helper_count;
    if (known) {
        name->role = ROLE_HELPER;
        parameters = p->list->helpers[helper].parameter_count;
        p->text->uses[helper] = true;
    }
    if (!known && parse_builtin(name, &parameters)) {
        known = true;
        name->role = ROLE_BUILTIN;
    }
    if (!known) {
        parse_refuse(p, name, "a built-in function or a helper of shaders/forms/helpers");
        return TYPE_ERROR;
    }
    parse_next(p);
    if (!parse_take(p, "("))
        return TYPE_ERROR;
    do {
        const token *argument = p->at;
        type found = parse_expression(p);
        if (found == TYPE_ERROR)
            return TYPE_ERROR;
        if (found != TYPE_REAL) {
            parse_refuse(p, argument, "an argument of type real");
            return TYPE_ERROR;
        }
        given++;
    } while (token_is(p->at, ",") && (parse_next(p), true));
    if (given != parameters) {
        base_error("%s:%d: expected %zu argument%s of %.*s, found %zu", p->text->path, name->line,
                   parameters, parameters == 1 ? "" : "s", (int)name->length, name->start, given);
        return TYPE_ERROR;
    }
    return parse_take(p, ")") ? TYPE_REAL : TYPE_ERROR;
}

static type name(parser *p)
{
    token *at = p->at;
    if (token_is(at, "K"))
        return literal(p);
    if (token_is(at, "true") || token_is(at, "false")) {
        parse_next(p);
        return TYPE_BOOL;
    }
    const variable *known = parse_variable(p, at);
    if (known) {
        parse_next(p);
        return known->type;
    }
    if (parse_coefficient(p, at, &at->index)) {
        at->role = ROLE_COEFFICIENT;
        parse_next(p);
        return TYPE_REAL;
    }
    if (token_is(at, "sg_pi")) {
        at->role = ROLE_PI;
        p->text->uses_pi = true;
        parse_next(p);
        return TYPE_REAL;
    }
    const token *after = at + 1;
    while (after->kind == TOKEN_BLANK)
        after++;
    if (token_is(after, "("))
        return call(p);
    parse_refuse(p, at, "a variable declared above, a parameter or a coefficient");
    return TYPE_ERROR;
}

static type primary(parser *p)
{
    if (p->at->kind == TOKEN_NUMBER) {
        parse_refuse(p, p->at, "every literal inside K(...)");
        return TYPE_ERROR;
    }
    if (p->at->kind == TOKEN_NAME)
        return name(p);
    if (!token_is(p->at, "(")) {
        parse_refuse(p, p->at, "an expression");
        return TYPE_ERROR;
    }
    parse_next(p);
    type found = parse_expression(p);
    return found != TYPE_ERROR && parse_take(p, ")") ? found : TYPE_ERROR;
}

static type unary(parser *p)
{
    type wanted = token_is(p->at, "!") ? TYPE_BOOL : TYPE_REAL;
    if (!token_is(p->at, "!") && !token_is(p->at, "-") && !token_is(p->at, "+"))
        return primary(p);
    parse_next(p);
    const token *operand = p->at;
    type found = primary(p); /* no chains: --x is another operator */
    if (found != TYPE_ERROR && found != wanted) {
        parse_refuse(p, operand,
                     wanted == TYPE_BOOL ? "a bool after '!'" : "a real after the sign");
        return TYPE_ERROR;
    }
    return found;
}

/* Binary operators by binding strength, loosest first. */
static const struct level {
    const char *signs[4];
    type operands, result;
} levels[] = {
    {{"||"}, TYPE_BOOL, TYPE_BOOL},       {{"&&"}, TYPE_BOOL, TYPE_BOOL},
    {{"==", "!="}, TYPE_REAL, TYPE_BOOL}, {{"<", ">", "<=", ">="}, TYPE_REAL, TYPE_BOOL},
    {{"+", "-"}, TYPE_REAL, TYPE_REAL},   {{"*", "/"}, TYPE_REAL, TYPE_REAL},
};
enum { LEVELS = sizeof levels / sizeof levels[0] };

static bool operator_of(const token *at, size_t level)
{
    for (size_t i = 0; i < 4 && levels[level].signs[i]; i++) {
        if (token_is(at, levels[level].signs[i]))
            return true;
    }
    return false;
}

static type binary(parser *p, size_t level)
{
    if (level == LEVELS)
        return unary(p);
    const token *left_at = p->at;
    type left = binary(p, level + 1);
    while (left != TYPE_ERROR && operator_of(p->at, level)) {
        parse_next(p);
        const token *right_at = p->at;
        type right = binary(p, level + 1);
        if (right == TYPE_ERROR)
            return TYPE_ERROR;
        if (left != levels[level].operands || right != levels[level].operands) {
            parse_refuse(p, left != levels[level].operands ? left_at : right_at,
                         levels[level].operands == TYPE_BOOL ? "an operand of type bool"
                                                             : "an operand of type real");
            return TYPE_ERROR;
        }
        left = levels[level].result;
    }
    return left;
}

static type choice(parser *p)
{
    const token *condition_at = p->at;
    type condition = binary(p, 0);
    if (condition == TYPE_ERROR || !token_is(p->at, "?"))
        return condition;
    if (condition != TYPE_BOOL) {
        parse_refuse(p, condition_at, "a condition of type bool before '?'");
        return TYPE_ERROR;
    }
    parse_next(p);
    type yes = parse_expression(p);
    if (yes == TYPE_ERROR || !parse_take(p, ":"))
        return TYPE_ERROR;
    const token *no_at = p->at;
    type no = parse_expression(p);
    if (no != TYPE_ERROR && no != yes) {
        parse_refuse(p, no_at, "the type that the other branch of '?:' has");
        return TYPE_ERROR;
    }
    return no;
}

type parse_expression(parser *p)
{
    if (++p->depth > DEPTH_MAX) {
        parse_refuse(p, p->at, "fewer nested parentheses");
        return TYPE_ERROR;
    }
    type found = choice(p);
    p->depth--;
    return found;
}
