/* check.c: the function of a form or helper text, statement by statement. */
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "parse.h"

/* Words that one of the two languages keeps for itself and that a formula might be tempted by. */
static const char *const reserved[] = {
    "active",  "attribute", "auto",   "buffer",  "case",     "cast",      "common",  "const",
    "double",  "filter",    "fixed",  "flat",    "float",    "for",       "goto",    "half",
    "highp",   "if",        "inline", "input",   "int",      "invariant", "long",    "lowp",
    "mediump", "output",    "patch",  "precise", "register", "sample",    "sampler", "shared",
    "short",   "signed",    "smooth", "static",  "struct",   "superp",    "switch",  "uniform",
    "union",   "unsigned",  "using",  "varying", "void",     "volatile",  "while",   "else"};

static type type_of(const token *at)
{
    return token_is(at, "real") ? TYPE_REAL : token_is(at, "bool") ? TYPE_BOOL : TYPE_ERROR;
}

static bool take_type(parser *p, type *found)
{
    *found = type_of(p->at);
    if (*found == TYPE_ERROR)
        return parse_refuse(p, p->at, "the type real or bool");
    if (*found == TYPE_REAL)
        p->at->role = ROLE_REAL;
    parse_next(p);
    return true;
}

/* A new name must mean nothing yet, in either language. */
static bool declare(parser *p, type of, bool constant)
{
    const token *name = p->at;
    size_t unused;
    if (name->kind != TOKEN_NAME)
        return parse_refuse(p, name, "a name");
    bool taken = parse_variable(p, name) || parse_coefficient(p, name, &unused) ||
                 parse_builtin(name, &unused) ||
                 forms_helper(p->list, name->start, name->length) < p->list->helper_count ||
                 token_is(name, "sg_pi") || token_is(name, "K") || token_is(name, "sg_k") ||
                 type_of(name) != TYPE_ERROR ||
                 memchr(name->start, '_', name->length) == name->start;
    for (size_t i = 0; !taken && i < sizeof reserved / sizeof reserved[0]; i++)
        taken = token_is(name, reserved[i]);
    if (taken)
        return parse_refuse(p, name, "a name that is not taken yet (in C, in GLSL or above)");
    if (p->variable_count == VARIABLES_MAX)
        return parse_refuse(p, name, "fewer variables");
    p->variables[p->variable_count++] = (variable){name, of, constant};
    parse_next(p);
    return true;
}

/* real NAME(real a, real b) */
static bool head(parser *p)
{
    form *text = p->text;
    const char *wanted = text->helper ? text->id : "sg_form";
    type found;
    parse_skip(p);
    if (!take_type(p, &found))
        return false;
    if (found != TYPE_REAL)
        return parse_refuse(p, p->at, "a function that returns real before this name");
    if (!token_is(p->at, wanted)) {
        base_error("%s:%d: expected the function's name %s, found '%.*s'", text->path, p->at->line,
                   wanted, (int)p->at->length, p->at->start);
        return false;
    }
    p->at->role = text->helper ? ROLE_HELPER : ROLE_SELF;
    parse_next(p);
    if (!parse_take(p, "("))
        return false;
    text->parameter_count = 0;
    do {
        if (!take_type(p, &found))
            return false;
        if (found != TYPE_REAL)
            return parse_refuse(p, p->at, "a parameter of type real");
        if (!text->helper && !token_is(p->at, text->parameter_count ? "cos_theta" : "lambda"))
            return parse_refuse(p, p->at, "the parameters (real lambda, real cos_theta)");
        if (!declare(p, found, false))
            return false;
        text->parameter_count++;
    } while (token_is(p->at, ",") && (parse_next(p), true));
    if (!text->helper && text->parameter_count != 2)
        return parse_refuse(p, p->at, "the parameters (real lambda, real cos_theta)");
    return parse_take(p, ")");
}

static bool value(parser *p, type wanted)
{
    const token *at = p->at;
    type found = parse_expression(p);
    if (found == TYPE_ERROR)
        return false;
    if (found != wanted)
        return parse_refuse(p, at,
                            wanted == TYPE_REAL ? "a value of type real" : "a value of type bool");
    return parse_take(p, ";");
}

static bool statement(parser *p)
{
    bool constant = token_is(p->at, "const");
    if (constant)
        parse_next(p);
    if (constant || type_of(p->at) != TYPE_ERROR) {
        type of;
        if (!take_type(p, &of))
            return false;
        /* Declared after its value is read: it may not be used in it. */
        token *name = p->at;
        if (!declare(p, of, constant))
            return false;
        p->variable_count--;
        if (!parse_take(p, "=") || !value(p, of))
            return false;
        p->variables[p->variable_count++] = (variable){name, of, constant};
        return true;
    }
    const variable *known = p->at->kind == TOKEN_NAME ? parse_variable(p, p->at) : NULL;
    if (!known)
        return parse_refuse(p, p->at,
                            "a declaration, an assignment to a variable or return (there is no if "
                            "and no loop: use ?:)");
    if (known->constant)
        return parse_refuse(p, p->at, "a variable that is not const");
    parse_next(p);
    static const char *const signs[] = {"=", "+=", "-=", "*=", "/="};
    for (size_t i = 0; i < sizeof signs / sizeof signs[0]; i++) {
        if (token_is(p->at, signs[i]) && (i == 0 || known->type == TYPE_REAL)) {
            parse_next(p);
            return value(p, known->type);
        }
    }
    return parse_refuse(p, p->at, "an assignment");
}

bool form_signature(form *text)
{
    static const form_list none;
    parser p = {.text = text, .list = &none, .at = text->tokens};
    return head(&p);
}

bool form_check(form *text, const form_list *list)
{
    parser p = {.text = text, .list = list, .at = text->tokens};
    text->uses = base_allocate((list->helper_count + 1) * sizeof *text->uses);
    memset(text->uses, 0, (list->helper_count + 1) * sizeof *text->uses);
    if (!head(&p) || !parse_take(&p, "{"))
        return false;
    while (!token_is(p.at, "return")) {
        if (!statement(&p))
            return false;
    }
    parse_next(&p);
    if (!value(&p, TYPE_REAL) || !parse_take(&p, "}"))
        return false;
    if (p.at->kind != TOKEN_END)
        return parse_refuse(&p, p.at, "nothing after the function");
    return true;
}
