/* certified.c: enclosures by rigorous integration of
 *     A_h = 2 pi int_0^{pi/2} exp(-2 lambda sin^2((beta - th)/2)) e^-x I0(x) cos th sin th dth,
 *     x = lambda sin beta sin th,
 * and of H, which lacks cos th. The integrand is entire, so acb_calc_integrate may bound it
 * anywhere. Outside the window |th - beta| <= w the exponential is below its value at w, which
 * bounds what is left out; the window is what keeps the work small for sharp lobes. */
#include "certified.h"

#ifdef HAVE_ARB

#include <acb_calc.h>
#include <acb_hypgeom.h>
#include <arb.h>
#include <math.h>

typedef struct integrand {
    arb_t lambda, beta, sine_product; /* lambda sin beta */
    bool with_cosine;
} integrand;

static int evaluate(acb_ptr out, const acb_t theta, void *context, slong order, slong bits)
{
    const integrand *f = context;
    (void)order; /* nothing to refuse: the integrand is entire */
    acb_t sine, cosine, x, zero, exponent;
    acb_init(sine), acb_init(cosine), acb_init(x), acb_init(zero), acb_init(exponent);
    acb_sin_cos(sine, cosine, theta, bits);
    acb_mul_arb(x, sine, f->sine_product, bits);
    acb_hypgeom_bessel_i_scaled(out, zero, x, bits);
    acb_mul(out, out, sine, bits);
    if (f->with_cosine)
        acb_mul(out, out, cosine, bits);
    acb_sub_arb(exponent, theta, f->beta, bits);
    acb_mul_2exp_si(exponent, exponent, -1);
    acb_sin(exponent, exponent, bits);
    acb_sqr(exponent, exponent, bits);
    acb_mul_arb(exponent, exponent, f->lambda, bits);
    acb_mul_si(exponent, exponent, -2, bits);
    acb_exp(exponent, exponent, bits);
    acb_mul(out, out, exponent, bits);
    acb_clear(sine), acb_clear(cosine), acb_clear(x), acb_clear(zero), acb_clear(exponent);
    return 0;
}

/* The half width of the window for an exponent `drop` below that of its peak in [0, pi/2], the
 * peak being at distance `gap` from beta. Any width is correct; this one is efficient. */
static double window(double lambda, double gap, double drop)
{
    double start = sin(0.5 * gap);
    double square = start * start + 0.5 * drop / fmax(lambda, 1e-300);
    return square >= 1.0 ? 4.0 : 2.0 * asin(sqrt(square));
}

/* Adds to `sum` the enclosure [0, length exp(-2 lambda sin^2(w/2))] of one side left out. */
static void add_tail(arb_t sum, const arb_t lambda, const arb_t w, slong bits)
{
    arb_t bound;
    arb_init(bound);
    arb_mul_2exp_si(bound, w, -1);
    arb_sin(bound, bound, bits);
    arb_sqr(bound, bound, bits);
    arb_mul(bound, bound, lambda, bits);
    arb_mul_si(bound, bound, -2, bits);
    arb_exp(bound, bound, bits);
    arb_mul_2exp_si(bound, bound, 1); /* sides are shorter than 2 */
    arb_t zero;
    arb_init(zero);
    arb_union(bound, zero, bound, bits);
    arb_add(sum, sum, bound, bits);
    arb_clear(bound), arb_clear(zero);
}

/* The exponent has to be known to goal bits absolutely. */
static slong working_bits(double lambda, slong goal)
{
    return goal + 40 + (lambda > 1.0 ? (slong)ceil(log2(lambda)) : 0);
}

/* A_h or H with about `goal` bits. */
static void enclose(arb_t value, double sharpness, const arb_t beta, bool with_cosine, slong goal)
{
    double angle = arf_get_d(arb_midref(beta), ARF_RND_NEAR);
    slong bits = working_bits(sharpness, goal);
    arb_t lambda;
    arb_init(lambda);
    arb_set_d(lambda, sharpness);
    integrand f = {.with_cosine = with_cosine};
    arb_init(f.lambda), arb_init(f.beta), arb_init(f.sine_product);
    arb_set(f.lambda, lambda), arb_set(f.beta, beta);
    arb_sin(f.sine_product, beta, bits);
    arb_mul(f.sine_product, f.sine_product, lambda, bits);

    const double half_pi = 1.57079632679489661923;
    double drop = (double)goal * 0.7 + 2.0 * log1p(sharpness) + 5.0;
    double gap = angle > half_pi ? angle - half_pi : 0.0;
    arb_t w, low, high, left_out;
    arb_init(w), arb_init(low), arb_init(high), arb_init(left_out);
    arb_set_d(w, window(sharpness, gap, drop));
    arb_const_pi(high, bits);
    arb_mul_2exp_si(high, high, -1);
    acb_t from, to, result;
    acb_init(from), acb_init(to), acb_init(result);
    arb_sub(low, beta, w, bits);
    if (arb_is_positive(low)) {
        arb_get_mid_arb(acb_realref(from), low);
        /* the midpoint may differ from low by its radius: bound from the point itself */
        arb_sub(low, beta, acb_realref(from), bits);
        add_tail(left_out, lambda, low, bits);
    }
    arb_add(low, beta, w, bits);
    arb_set(acb_realref(to), high);
    if (arb_lt(low, high)) {
        arb_get_mid_arb(acb_realref(to), low);
        arb_sub(low, acb_realref(to), beta, bits);
        add_tail(left_out, lambda, low, bits);
    }

    mag_t tolerance;
    mag_init(tolerance);
    /* absolute tolerance: the size of the peak, well below any value this integral can have */
    double exponent = -2.0 * sharpness * pow(sin(0.5 * gap), 2.0) - 3.0 * log1p(sharpness) - 5.0;
    arb_set_d(low, fmax(exponent, -2e6));
    arb_exp(low, low, 53);
    arb_get_mag_lower(tolerance, low);
    mag_mul_2exp_si(tolerance, tolerance, -goal);
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    options->depth_limit = 4 * bits;
    acb_calc_integrate(result, evaluate, &f, from, to, goal, tolerance, options, bits);
    arb_add(value, acb_realref(result), left_out, bits);
    arb_mul(value, value, high, bits);
    arb_mul_2exp_si(value, value, 2);

    mag_clear(tolerance);
    acb_clear(from), acb_clear(to), acb_clear(result);
    arb_clear(w), arb_clear(low), arb_clear(high), arb_clear(left_out), arb_clear(lambda);
    arb_clear(f.lambda), arb_clear(f.beta), arb_clear(f.sine_product);
}

typedef enum quantity { QUANTITY_A_H, QUANTITY_H, QUANTITY_L, QUANTITY_C, QUANTITY_S } quantity;

/* A_h/A */
static void divide_by_A(arb_t value, double sharpness, slong bits)
{
    arb_t A, lambda;
    arb_init(A), arb_init(lambda);
    arb_const_pi(A, bits);
    arb_mul_2exp_si(A, A, 2);
    if (sharpness > 0.0) {
        arb_set_d(lambda, sharpness);
        arb_div(A, A, lambda, bits);
        arb_mul_si(lambda, lambda, -2, bits);
        arb_expm1(lambda, lambda, bits);
        arb_mul(A, A, lambda, bits);
        arb_mul_2exp_si(A, A, -1);
        arb_neg(A, A);
    }
    arb_div(value, value, A, bits);
    arb_clear(A), arb_clear(lambda);
}

/* (A_h - A_b)/(A_u - A_b), from the closed forms of A_u and A_b */
static void to_curve(arb_t value, double sharpness, slong bits)
{
    arb_t lambda, decay, up, down;
    arb_init(lambda), arb_init(decay), arb_init(up), arb_init(down);
    arb_set_d(lambda, sharpness);
    arb_neg(decay, lambda);
    arb_exp(decay, decay, bits);
    /* lambda^2 A_u/2 pi = e^-l - 1 + l; lambda^2 A_b/2 pi = e^-l (1 - e^-l (1 + l)) */
    arb_add(up, decay, lambda, bits);
    arb_sub_si(up, up, 1, bits);
    arb_add_si(down, lambda, 1, bits);
    arb_mul(down, down, decay, bits);
    arb_sub_si(down, down, 1, bits);
    arb_mul(down, down, decay, bits);
    arb_neg(down, down);
    arb_sqr(lambda, lambda, bits);
    arb_mul(value, value, lambda, bits);
    arb_const_pi(lambda, bits);
    arb_mul_2exp_si(lambda, lambda, 1);
    arb_div(value, value, lambda, bits);
    arb_sub(value, value, down, bits);
    arb_sub(up, up, down, bits);
    arb_div(value, value, up, bits);
    arb_clear(lambda), arb_clear(decay), arb_clear(up), arb_clear(down);
}

/* Meder's eq. 16 solved: 2 (c - max(z, 0))/(1 - |z|) */
static void to_blend(arb_t value, const arb_t cosine, slong bits)
{
    arb_t size;
    arb_init(size);
    arb_abs(size, cosine);
    if (arb_is_nonnegative(cosine))
        arb_sub(value, value, cosine, bits);
    arb_sub_si(size, size, 1, bits);
    arb_neg(size, size);
    arb_div(value, value, size, bits);
    arb_mul_2exp_si(value, value, 1);
    arb_clear(size);
}

/* direction: beta, or cos beta if by_cosine. */
static bool certify(quantity what, double lambda, double direction, bool by_cosine, double *lower,
                    double *upper)
{
    if (!(lambda >= 0.0) || isinf(lambda) ||
        !(by_cosine ? fabs(direction) <= 1.0
                    : direction >= 0.0 && direction <= 3.14159265358979312))
        return false;
    double z = by_cosine ? direction : cos(direction);
    slong goal = 66;
    if (what == QUANTITY_C || what == QUANTITY_S) {
        /* what the differences of the definition take away */
        double left = fmin(lambda, 1.0) * (1.0 - fabs(z));
        if (!(left > 1e-60)) {
            /* A_h rises from A_b to A_u, and s = 2 (L(-|z|) - L(-1))/(m (1 - |z|)) depends on |z|
             * alone, where c <= 1 reads s <= 2. */
            *lower = 0.0;
            *upper = what == QUANTITY_C ? 1.0 : 2.0;
            return false;
        }
        goal += (slong)(-3.0 * log2(left)) + (slong)log2(1.0 + lambda);
    }
    slong bits = working_bits(lambda, goal);
    arb_t beta, cosine, value;
    arb_init(beta), arb_init(cosine), arb_init(value);
    arb_set_d(by_cosine ? cosine : beta, direction);
    if (by_cosine)
        arb_acos(beta, cosine, bits);
    else
        arb_cos(cosine, beta, bits);
    enclose(value, lambda, beta, what != QUANTITY_H, goal);
    if (what == QUANTITY_L)
        divide_by_A(value, lambda, bits);
    if (what == QUANTITY_C || what == QUANTITY_S)
        to_curve(value, lambda, bits);
    if (what == QUANTITY_S)
        to_blend(value, cosine, bits);
    arf_t bound;
    arf_init(bound);
    arb_get_lbound_arf(bound, value, bits);
    *lower = fmax(arf_get_d(bound, ARF_RND_FLOOR), 0.0);
    arb_get_ubound_arf(bound, value, bits);
    *upper = arf_get_d(bound, ARF_RND_CEIL);
    arf_clear(bound);
    double scale = what == QUANTITY_S ? 1.0 : *lower;
    arb_clear(beta), arb_clear(cosine), arb_clear(value);
    return *upper - *lower <= fmax(1e-15 * scale, 0x1p-1072);
}

#define ENTRY(name, what)                                                                          \
    bool sgfit_certified_##name(double lambda, double beta, double *lower, double *upper)          \
    {                                                                                              \
        return certify(what, lambda, beta, false, lower, upper);                                   \
    }                                                                                              \
    bool sgfit_certified_##name##_cos(double lambda, double cos_theta, double *lower,              \
                                      double *upper)                                               \
    {                                                                                              \
        return certify(what, lambda, cos_theta, true, lower, upper);                               \
    }

ENTRY(A_h, QUANTITY_A_H)
ENTRY(H, QUANTITY_H)
ENTRY(L, QUANTITY_L)
ENTRY(c, QUANTITY_C)
ENTRY(s, QUANTITY_S)

#endif
