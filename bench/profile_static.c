/* profile_static.c: what a form costs by its text alone, where no compiler is there to be asked. */
#include "profile_fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"

enum { MOST_NODES = 1000, MOST_NAMES = 64 };

typedef enum kind { CONSTANT, ARGUMENT, SIGN, SUM, PRODUCT, QUOTIENT, CALL } kind;

typedef struct node {
    kind kind;
    double value;     /* of a constant */
    const char *name; /* of a function: points into the text */
    size_t length;
    int parts[3]; /* -1: none */
    int uses;
} node;

typedef struct name {
    const token *token;
    int node;
} name;

typedef struct reader {
    const form *text;
    const double *coefficients;
    const token *at;
    node nodes[MOST_NODES];
    int node_count;
    name names[MOST_NAMES];
    int name_count;
    bool failed;
} reader;

static int expression(reader *r);

/* ---- Nodes, folded as they are made -------------------------------------------------------- */

static bool is(const reader *r, int at, double value)
{
    return r->nodes[at].kind == CONSTANT && r->nodes[at].value == value;
}

/* The node, or an equal one that is there already. */
static int keep(reader *r, node made)
{
    for (int i = 0; i < r->node_count; i++) {
        const node *n = &r->nodes[i];
        if (n->kind == made.kind && n->value == made.value && n->length == made.length &&
            memcmp(n->parts, made.parts, sizeof made.parts) == 0 &&
            (made.length == 0 || memcmp(n->name, made.name, made.length) == 0))
            return i;
    }
    if (r->node_count == MOST_NODES) {
        r->failed = true;
        return 0;
    }
    r->nodes[r->node_count] = made;
    return r->node_count++;
}

static int constant(reader *r, double value)
{
    return keep(r, (node){.kind = CONSTANT, .value = value, .parts = {-1, -1, -1}});
}

static int two(reader *r, kind kind, int a, int b)
{
    const node *x = &r->nodes[a], *y = &r->nodes[b];
    if (x->kind == CONSTANT && y->kind == CONSTANT)
        return constant(r, kind == SUM       ? x->value + y->value
                           : kind == PRODUCT ? x->value * y->value
                                             : x->value / y->value);
    if (kind == SUM && (is(r, a, 0.0) || is(r, b, 0.0)))
        return is(r, a, 0.0) ? b : a;
    if (kind != SUM && (is(r, a, 0.0) || (kind == PRODUCT && is(r, b, 0.0))))
        return constant(r, 0.0);
    if (kind != SUM && is(r, b, 1.0))
        return a;
    if (kind == PRODUCT && is(r, a, 1.0))
        return b;
    return keep(r, (node){.kind = kind, .parts = {a, b, -1}});
}

static int negative(reader *r, int a)
{
    if (r->nodes[a].kind == CONSTANT)
        return constant(r, -r->nodes[a].value);
    return keep(r, (node){.kind = SIGN, .parts = {a, -1, -1}});
}

/* ---- Reading ------------------------------------------------------------------------------- */

static void next(reader *r)
{
    do
        r->at++;
    while (r->at->kind == TOKEN_BLANK);
}

static bool take(reader *r, const char *sign)
{
    bool there = r->at->kind != TOKEN_END && token_is(r->at, sign);
    if (there)
        next(r);
    return there;
}

static void expect(reader *r, const char *sign)
{
    if (!take(r, sign))
        r->failed = true;
}

static int call(reader *r, const token *function)
{
    node made = {
        .kind = CALL, .name = function->start, .length = function->length, .parts = {-1, -1, -1}};
    for (int i = 0; i < 3 && !r->failed; i++) {
        made.parts[i] = expression(r);
        if (!take(r, ","))
            break;
    }
    expect(r, ")");
    bool unit = made.parts[2] >= 0 && is(r, made.parts[1], 0.0) && is(r, made.parts[2], 1.0);
    if (token_is(function, "abs") || (token_is(function, "clamp") && unit))
        made.kind = SIGN;
    return r->failed ? 0 : keep(r, made);
}

static int variable(reader *r, const token *t)
{
    for (int i = r->name_count - 1; i >= 0; i--)
        if (r->names[i].token->length == t->length &&
            memcmp(r->names[i].token->start, t->start, t->length) == 0)
            return r->names[i].node;
    if (t->role == ROLE_PI)
        return constant(r, 3.14159265358979);
    if (!token_is(t, "lambda") && !token_is(t, "cos_theta"))
        r->failed = true;
    return keep(
        r, (node){.kind = ARGUMENT, .name = t->start, .length = t->length, .parts = {-1, -1, -1}});
}

static int primary(reader *r)
{
    const token *t = r->at;
    if (take(r, "-"))
        return negative(r, primary(r));
    if (take(r, "(")) {
        int inner = expression(r);
        expect(r, ")");
        return inner;
    }
    if (t->kind == TOKEN_NUMBER) {
        double value = 0.0;
        if (!base_parse_f64(t->start, t->length, &value))
            r->failed = true;
        next(r);
        return constant(r, value);
    }
    if (t->kind != TOKEN_NAME) {
        r->failed = true;
        return 0;
    }
    next(r);
    if (t->role == ROLE_COEFFICIENT)
        return constant(r, r->coefficients[t->index]);
    if (!take(r, "("))
        return variable(r, t);
    if (t->role != ROLE_LITERAL)
        return call(r, t);
    int inner = expression(r);
    expect(r, ")");
    return inner;
}

static int product(reader *r)
{
    int left = primary(r);
    while (!r->failed) {
        if (take(r, "*"))
            left = two(r, PRODUCT, left, primary(r));
        else if (take(r, "/"))
            left = two(r, QUOTIENT, left, primary(r));
        else
            break;
    }
    return left;
}

static int expression(reader *r)
{
    int left = product(r);
    while (!r->failed) {
        if (take(r, "+"))
            left = two(r, SUM, left, product(r));
        else if (take(r, "-"))
            left = two(r, SUM, left, negative(r, product(r)));
        else
            break;
    }
    return left;
}

/* real x = ...; x = ...; return ...; The node that is returned. */
static int body(reader *r)
{
    while (r->at->kind != TOKEN_END && !token_is(r->at, "{"))
        r->at++;
    expect(r, "{");
    while (!r->failed) {
        if (take(r, "return"))
            return expression(r);
        if (r->at->role == ROLE_REAL)
            next(r);
        const token *target = r->at;
        next(r);
        expect(r, "=");
        int value = expression(r);
        expect(r, ";");
        if (r->name_count == MOST_NAMES)
            r->failed = true;
        else
            r->names[r->name_count++] = (name){target, value};
    }
    return 0;
}

/* ---- Counting ------------------------------------------------------------------------------ */

static void use(reader *r, int at)
{
    if (at < 0 || r->nodes[at].uses++ > 0)
        return;
    for (int i = 0; i < 3; i++)
        use(r, r->nodes[at].parts[i]);
}

/* A product, perhaps with its sign changed, that nothing but this sum uses. */
static bool joins(const reader *r, int at)
{
    while (r->nodes[at].kind == SIGN && r->nodes[at].uses == 1)
        at = r->nodes[at].parts[0];
    return r->nodes[at].kind == PRODUCT && r->nodes[at].uses == 1;
}

static int cost(const reader *r, const node *n)
{
    if (n->uses == 0 || n->kind == CONSTANT || n->kind == ARGUMENT || n->kind == SIGN)
        return 0;
    if (n->kind == QUOTIENT)
        return is(r, n->parts[0], 1.0) ? 1 : 2;
    if (n->kind == SUM)
        return joins(r, n->parts[0]) || joins(r, n->parts[1]) ? 0 : 1; /* counted as the product */
    return 1;
}

bool profile_static_count(const form *text, const double *coefficients, double *count)
{
    reader *r = base_allocate(sizeof *r);
    memset(r, 0, sizeof *r);
    r->text = text;
    r->coefficients = coefficients;
    r->at = text->tokens;
    use(r, body(r));
    *count = 0.0;
    for (int i = 0; i < r->node_count; i++)
        *count += cost(r, &r->nodes[i]);
    bool good = !r->failed;
    if (!good)
        base_error("%s: expected sums, products, quotients and calls alone, to be counted without "
                   "RADV",
                   text->path);
    free(r);
    return good;
}
