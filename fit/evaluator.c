#include "fit/evaluator.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#ifdef HAVE_ARB
#include "fit/certified.h"
#endif

/* The double nearest to pi, which is below it. */
static const double pi = 3.14159265358979311600;
/* Dot products of unit vectors in float miss [-1, 1] by less than this. */
static const double cosine_slack = 1e-6;

static bool is(const char *a, const char *b)
{
    return strcmp(a, b) == 0;
}

static bool find(evaluator *evaluator, const char *id)
{
    if (is(id, "reference"))
        evaluator->kind = EVALUATE_REFERENCE;
    else if ((evaluator->method = sg_method_find(id)) != NULL)
        evaluator->kind = EVALUATE_METHOD;
    else if ((evaluator->route = sg_route_find(id)) != NULL)
        evaluator->kind = EVALUATE_ROUTE;
    else
        return false;
    return true;
}

static bool has_half(const evaluator *evaluator)
{
    return evaluator->method->A_h_f16 != NULL && evaluator->method->L_f16 != NULL;
}

bool evaluator_choose(evaluator *evaluator, const char *id, const char *quantity,
                      const char *precision, bool certified)
{
    *evaluator =
        (struct evaluator){.quantity = quantity, .precision = precision, .certified = certified};
    bool common = is(quantity, "A_h") || is(quantity, "L");
    if (!find(evaluator, id))
        base_error("eval: unknown method \"%s\", expected reference, an id of sgfit methods or a "
                   "route of sgfit eval --help",
                   id);
    else if (evaluator->kind != EVALUATE_REFERENCE && !common)
        base_error("eval: --quantity expects A_h or L with --method %s, found \"%s\"", id,
                   quantity);
    else if (evaluator->kind != EVALUATE_METHOD && !is(precision, "f64"))
        base_error("eval: --precision expects f64 with --method %s, found \"%s\"", id, precision);
    else if (is(precision, "f16") && !has_half(evaluator))
        base_error("eval: --precision f16 expects a compiler with half floats, and this program "
                   "was built without");
    else if (certified && evaluator->kind != EVALUATE_REFERENCE)
        base_error("eval: --certified expects --method reference, found \"%s\"", id);
#ifndef HAVE_ARB
    else if (certified)
        base_error("eval: --certified expects a build with FLINT/Arb, and this one is without");
#endif
    else
        return true;
    return false;
}

size_t evaluator_extras(const evaluator *evaluator, const char *names[EVALUATOR_EXTRAS])
{
    if (evaluator->kind == EVALUATE_ROUTE) {
        names[0] = "claimed_error";
        return 1;
    }
    if (evaluator->certified) {
        names[0] = "lower";
        names[1] = "upper";
        return 2;
    }
    return 0;
}

static double reference_value(const evaluator *evaluator, double lambda, double angle)
{
    bool beta = evaluator->by_beta;
    switch (evaluator->quantity[0]) {
    case 'A':
        return beta ? sg_A_h(lambda, angle) : sg_A_h_cos(lambda, angle);
    case 'H':
        return beta ? sg_H(lambda, angle) : sg_H_cos(lambda, angle);
    case 'L':
        return beta ? sg_L(lambda, angle) : sg_L_cos(lambda, angle);
    case 'c':
        return beta ? sg_c(lambda, angle) : sg_c_cos(lambda, angle);
    default:
        return beta ? sg_s(lambda, angle) : sg_s_cos(lambda, angle);
    }
}

/* In the method's own unit: arguments are rounded to its precision first (f16 functions do that
 * themselves), the angle after its cosine was taken in double. */
static double method_value(const evaluator *evaluator, double lambda, double angle)
{
    const sg_method *method = evaluator->method;
    double cos_theta = evaluator->by_beta ? cos(angle) : angle;
    bool integral = is(evaluator->quantity, "A_h");
    if (is(evaluator->precision, "f64"))
        return (integral ? method->A_h_f64 : method->L_f64)(lambda, cos_theta);
    float l = (float)lambda, z = (float)cos_theta;
    if (is(evaluator->precision, "f32"))
        return (double)(integral ? method->A_h_f32 : method->L_f32)(l, z);
    return (double)(integral ? method->A_h_f16 : method->L_f16)(l, z);
}

static double route_value(const evaluator *evaluator, double lambda, double angle,
                          double *claimed_error)
{
    /* Where a route gives up it says so by its claim. */
    sg_quadrature result = {.value = (double)NAN, .claimed_error = (double)INFINITY};
    evaluator->route->A_h(lambda, evaluator->by_beta ? angle : acos(angle), &result);
    double scale = is(evaluator->quantity, "L") ? sg_A(lambda) : 1.0;
    *claimed_error = result.claimed_error / scale;
    return result.value / scale;
}

#ifdef HAVE_ARB
static void enclose(const evaluator *evaluator, double lambda, double angle,
                    double extras[EVALUATOR_EXTRAS])
{
    typedef bool (*enclosure)(double lambda, double angle, double *lower, double *upper);
    static const struct {
        const char *quantity;
        enclosure by_beta, by_cosine;
    } rows[] = {
        {"A_h", sgfit_certified_A_h, sgfit_certified_A_h_cos},
        {"H", sgfit_certified_H, sgfit_certified_H_cos},
        {"L", sgfit_certified_L, sgfit_certified_L_cos},
        {"c", sgfit_certified_c, sgfit_certified_c_cos},
        {"s", sgfit_certified_s, sgfit_certified_s_cos},
    };
    extras[0] = extras[1] = (double)NAN; /* c and s at the poles have no enclosure */
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (is(evaluator->quantity, rows[i].quantity))
            (evaluator->by_beta ? rows[i].by_beta : rows[i].by_cosine)(lambda, angle, &extras[0],
                                                                       &extras[1]);
}
#endif

double evaluator_value(const evaluator *evaluator, double lambda, double angle,
                       double extras[EVALUATOR_EXTRAS])
{
    switch (evaluator->kind) {
    case EVALUATE_METHOD:
        return method_value(evaluator, lambda, angle);
    case EVALUATE_ROUTE:
        return route_value(evaluator, lambda, angle, &extras[0]);
    default:
        break;
    }
#ifdef HAVE_ARB
    if (evaluator->certified)
        enclose(evaluator, lambda, angle, extras);
#endif
    return reference_value(evaluator, lambda, angle);
}

const char *evaluator_check_lambda(double *lambda)
{
    if (!(*lambda >= 0.0) || !isfinite(*lambda))
        return "a finite lambda of at least 0";
    *lambda += 0.0; /* -0 becomes 0 */
    return NULL;
}

const char *evaluator_check_angle(const evaluator *evaluator, double *angle)
{
    if (evaluator->by_beta) {
        if (!(*angle >= 0.0 && *angle <= pi))
            return "beta in [0, pi] radians, pi being 3.141592653589793";
        *angle += 0.0;
        return NULL;
    }
    if (!(fabs(*angle) <= 1.0 + cosine_slack))
        return "cos_theta in [-1, 1]";
    *angle = fmin(fmax(*angle, -1.0), 1.0);
    return NULL;
}
