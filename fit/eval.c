/* sgfit eval: options and help; eval_stream.c does the rows, evaluator.c the values. */
#include "fit/eval.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/options.h"
#include "base/text.h"
#include "fit/eval_stream.h"
#include "fit/evaluator.h"

static const char help[] =
    "Evaluates the reference, a method or a quadrature route at the points of a CSV on standard "
    "input, or at one point given by options. The header names lambda and beta (radians) or "
    "cos_theta, in any order; other columns are kept. Written are the same rows with a last "
    "column value, in the shortest text that reads back to the same double (to the same float with "
    "f32 and f16).\n\n"
    "Domain: every finite lambda >= 0; beta in [0, pi], not above the double 3.141592653589793; "
    "cos_theta in [-1, 1], where up to 1e-6 beyond counts as rounding and is taken as the end. "
    "Where a row has beta and cos_theta, beta is taken. With f32 and f16 the cosine of beta is "
    "taken in double, then lambda and cosine are rounded to the precision. Rows before a bad one "
    "are written.\n\n"
    "Quadrature routes, which add a column claimed_error before the value:";

/* The help text and the routes, so that the routes are listed nowhere by hand. */
static char *make_help(void)
{
    size_t size = sizeof help;
    for (size_t i = 0; i < sg_route_count(); i++)
        size += strlen(sg_route_at(i)->id) + strlen(sg_route_at(i)->title) + 32;
    char *text = malloc(size);
    if (!text)
        return NULL;
    strcpy(text, help);
    for (size_t i = 0; i < sg_route_count(); i++) {
        size_t used = strlen(text);
        snprintf(text + used, size - used, "\n  %-16s  %s", sg_route_at(i)->id,
                 sg_route_at(i)->title);
    }
    return text;
}

typedef struct arguments {
    const char *method, *quantity, *precision, *column;
    double lambda, beta, cos_theta;
    bool has_lambda, has_beta, has_cos_theta, certified, json;
} arguments;

static int parse(int argc, char **argv, arguments *a)
{
    char *text = make_help();
    const base_usage usage = {
        .command = "eval", .synopsis = "[--method ID] [options] [< FILE.csv]", .text = text};
    const base_option options[] = {
        {"method", BASE_STRING, &a->method, "ID",
         "reference (the default), an id of sgfit methods, or a route as above", NULL},
        {"quantity", BASE_CHOICE, &a->quantity, "A_h|H|L|c|s",
         "A_h (the default): integral of G times the clamped cosine; L: A_h over "
         "the integral of G; H: integral of G over the hemisphere; c and s: Meder's "
         "curves. The reference answers all, the others A_h and L",
         NULL},
        {"precision", BASE_CHOICE, &a->precision, "f64|f32|f16",
         "the method's double, float or half unit; the reference and the routes "
         "have f64 alone",
         NULL},
        {"certified", BASE_FLAG, &a->certified, NULL,
         "adds columns lower and upper: an enclosure by rigorous integration,\nnan where there is "
         "none (c and s at the poles)",
         NULL},
        {"lambda", BASE_F64, &a->lambda, "X", "one point instead of standard input: its sharpness",
         &a->has_lambda},
        {"beta", BASE_F64, &a->beta, "Y", "... and its angle in radians", &a->has_beta},
        {"cos-theta", BASE_F64, &a->cos_theta, "Z", "... or the cosine of its angle",
         &a->has_cos_theta},
        {"column", BASE_STRING, &a->column, "NAME", "name of the last column (default: value)",
         NULL},
        {"json", BASE_FLAG, &a->json, NULL, "writes an array of objects instead of CSV", NULL},
    };
    int status =
        base_parse_options(argc, argv, &usage, options, sizeof options / sizeof *options, NULL);
    free(text);
    return status;
}

static bool is_column_name(const char *name)
{
    return *name != '\0' && strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                         "0123456789_.+-") == strlen(name);
}

static int point(evaluator *evaluator, const eval_format *format, const arguments *a)
{
    if (!a->has_lambda) {
        base_error("eval: --%s expects --lambda with it", a->has_beta ? "beta" : "cos-theta");
        return BASE_USAGE;
    }
    if (a->has_beta == a->has_cos_theta) {
        base_error("eval: --lambda expects either --beta or --cos-theta with it, found %s",
                   a->has_beta ? "both" : "neither");
        return BASE_USAGE;
    }
    evaluator->by_beta = a->has_beta;
    double lambda = a->lambda, angle = a->has_beta ? a->beta : a->cos_theta;
    char found[BASE_NUMBER_SIZE];
    const char *expected = evaluator_check_lambda(&lambda);
    if (expected) {
        base_error("eval: --lambda: expected %s, found %s", expected,
                   base_shortest_f64(lambda, found));
        return BASE_USAGE;
    }
    if ((expected = evaluator_check_angle(evaluator, &angle)) != NULL) {
        base_error("eval: --%s: expected %s, found %s", a->has_beta ? "beta" : "cos-theta",
                   expected, base_shortest_f64(angle, found));
        return BASE_USAGE;
    }
    return eval_point(evaluator, format, lambda, angle);
}

int eval_command(int argc, char **argv)
{
    arguments a = {.method = "reference", .quantity = "A_h", .precision = "f64", .column = "value"};
    int status = parse(argc, argv, &a);
    if (status >= 0)
        return status;
    evaluator evaluator;
    if (!evaluator_choose(&evaluator, a.method, a.quantity, a.precision, a.certified))
        return BASE_USAGE;
    if (!is_column_name(a.column)) {
        base_error("eval: --column expects letters, digits and _ . + -, found \"%s\"", a.column);
        return BASE_USAGE;
    }
    const eval_format format = {.column = a.column, .json = a.json};
    if (a.has_lambda || a.has_beta || a.has_cos_theta)
        return point(&evaluator, &format, &a);
    if (isatty(STDIN_FILENO)) {
        base_error("eval: expected --lambda with --beta or --cos-theta, or CSV on standard input "
                   "(sgfit eval --help tells more)");
        return BASE_USAGE;
    }
    return eval_stream(&evaluator, &format, stdin, "standard input");
}
