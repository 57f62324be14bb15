/* kernel.h: the arithmetic of the reference integral, free of branches and of calls, so that a
 * loop over points or over quadrature nodes vectorises. Internal to libsg.
 *
 * With a = |pi/2 - beta| the angle to the horizon, delta = pi/2 - a the angle to the nearer pole,
 * and D = A_h(pi/2 + a) - A_b, the differential equation A_h'' + A_h = g gives
 *     D = 2 pi e^-lambda [ phi (1 - sin a) + int_0^delta sin(t) (I0(x) - I1(x)/x - 1/2) dt ],
 *     x = lambda cos(a + t),   phi = 1/2 - (1 - (1 + lambda) e^-lambda)/lambda^2,
 * every term of which is positive. The upper half follows from the exact odd part,
 *     A_h(beta) = A_h(pi - beta) + (A_u - A_b) cos(beta),
 * again a sum of positive terms; so does Meder's c = max(z, 0) + D/(A_u - A_b). H is the same with
 * H_b and int x e^-x I1(x)/x. Under the integral e^-lambda e^x is written e^-E e^-u with
 * E = lambda (1 - cos a), which is needed to 1e-15 absolute though it may be 600 and is therefore
 * carried in two doubles, and u = lambda (cos a - cos(a + t)), at which no care is needed: the
 * integral is cut where u = 40. The variable is y = sin(t/2): sin(t) dt = 4 y dy, and at the
 * horizon u is 2 lambda y^2, the easiest exponent for a Gauss rule. */
#ifndef SG_KERNEL_H
#define SG_KERNEL_H

#include "bessel_table.inc"
#include "double2.h"

#define SG_PI      3.14159265358979323846
#define SG_TWO_PI  6.28318530717958647693
#define SG_PI_HI   0x1.921fb54442d18p+1
#define SG_PI_LO   0x1.1a62633145c07p-53
#define SG_PI_REST (-0x1.f1976b7ed8fbcp-109)

/* What depends on lambda alone, each over 2 pi and times kappa = max(1, lambda), so that nothing
 * underflows: the integrals over the sphere and at the poles, the slope of the odd part. */
typedef struct sg_sharpness {
    double lambda, kappa;
    double pole; /* kappa A_b / 2 pi */
    double rise; /* kappa e^-lambda phi */
    double odd;  /* kappa (A_u - A_b)/2 pi */
    double all;  /* kappa A/2 pi */
    double dark; /* kappa H(pi)/2 pi */
} sg_sharpness;

static inline sg_sharpness sg_sharpness_of(double lambda)
{
    double e1 = sg_exp_minus(lambda, 0.0), e2 = e1 * e1;
    /* below 1 by series of positive terms, l being lambda there */
    double l = lambda < 1.0 ? lambda : 1.0, l2 = l * l;
    /* rise/l = e^-2lambda sum_{k>=0} (k(k+5)/2 + 2) l^k/(k+3)! */
    double rise = 189.0 / 2432902008176640000.0;
    rise = rise * l + 170.0 / 121645100408832000.0;
    rise = rise * l + 152.0 / 6402373705728000.0;
    rise = rise * l + 135.0 / 355687428096000.0;
    rise = rise * l + 119.0 / 20922789888000.0;
    rise = rise * l + 104.0 / 1307674368000.0;
    rise = rise * l + 90.0 / 87178291200.0;
    rise = rise * l + 77.0 / 6227020800.0;
    rise = rise * l + 65.0 / 479001600.0;
    rise = rise * l + 54.0 / 39916800.0;
    rise = rise * l + 44.0 / 3628800.0;
    rise = rise * l + 35.0 / 362880.0;
    rise = rise * l + 27.0 / 40320.0;
    rise = rise * l + 20.0 / 5040.0;
    rise = rise * l + 14.0 / 720.0;
    rise = rise * l + 9.0 / 120.0;
    rise = rise * l + 5.0 / 24.0;
    rise = rise * l + 2.0 / 6.0;
    /* odd/l = 2 e^-lambda sum_{k>=1} 2k l^(2k-2)/(2k+1)!, all = 2 e^-lambda sinh(l)/l */
    double odd = 18.0 / 121645100408832000.0, all = 1.0 / 121645100408832000.0;
    odd = odd * l2 + 16.0 / 355687428096000.0, all = all * l2 + 1.0 / 355687428096000.0;
    odd = odd * l2 + 14.0 / 1307674368000.0, all = all * l2 + 1.0 / 1307674368000.0;
    odd = odd * l2 + 12.0 / 6227020800.0, all = all * l2 + 1.0 / 6227020800.0;
    odd = odd * l2 + 10.0 / 39916800.0, all = all * l2 + 1.0 / 39916800.0;
    odd = odd * l2 + 8.0 / 362880.0, all = all * l2 + 1.0 / 362880.0;
    odd = odd * l2 + 6.0 / 5040.0, all = all * l2 + 1.0 / 5040.0;
    odd = odd * l2 + 4.0 / 120.0, all = all * l2 + 1.0 / 120.0;
    odd = odd * l2 + 2.0 / 6.0, all = all * l2 + 1.0 / 6.0;
    all = all * l2 + 1.0;

    double large = lambda > 1.0 ? lambda : 1.0, inverse = 1.0 / large;
    double without = (1.0 - (1.0 + large) * e1) * inverse; /* lambda b */
    int is_small = lambda <= 1.0;
    sg_sharpness s;
    s.lambda = lambda;
    s.kappa = large;
    s.rise = is_small ? e2 * rise * l : e1 * (0.5 * large - without);
    s.pole = is_small ? e1 * (0.5 - e1 * rise * l) : e1 * without;
    s.odd = is_small ? 2.0 * e1 * odd * l : (1.0 + e2) - (1.0 - e2) * inverse;
    s.all = is_small ? 2.0 * e1 * all : 1.0 - e2;
    /* (1 - e^-lambda) = (1 - e^-2lambda)/(1 + e^-lambda) */
    s.dark = e1 * s.all / (1.0 + e1);
    return s;
}

/* What depends on the direction alone. */
typedef struct sg_direction {
    double sine, cosine;   /* of a, both in [0, 1] */
    double one_minus_sine; /* accurate next to the poles */
    double pole_sine;      /* sin(delta/2) */
    sg_double2 one_minus_cosine;
    double z; /* cos beta = +-sine */
} sg_direction;

static inline sg_direction sg_direction_of_cosine(double z)
{
    double sine = fabs(z);
    sine = sine < 1.0 ? sine : 1.0;
    sg_double2 square = sg_two_product(sine, sine);
    sg_double2 rest = sg_two_sum(1.0, -square.hi);
    rest.lo -= square.lo;
    double sum = rest.hi + rest.lo;
    double root = sqrt(sum);
    /* one Newton step carries the root to two doubles; 2^-1000 is for root = 0 */
    sg_double2 root_square = sg_two_product(root, root);
    double defect = (rest.hi - root_square.hi) + (rest.lo - root_square.lo);
    double root_lo = defect / (2.0 * root + 0x1p-1000);
    sg_double2 divisor = sg_two_sum(1.0, root);
    divisor.lo += root_lo;
    double quotient = square.hi / divisor.hi;
    sg_double2 back = sg_two_product(quotient, divisor.hi);
    double remainder = ((square.hi - back.hi) - back.lo) + (square.lo - quotient * divisor.lo);
    sg_direction d;
    d.sine = sine;
    d.cosine = root;
    d.one_minus_sine = 1.0 - sine;
    d.pole_sine = sqrt(0.5 * d.one_minus_sine);
    d.one_minus_cosine = (sg_double2){quotient, remainder / divisor.hi};
    d.z = copysign(sine, z);
    return d;
}

/* 1 - cos a = q/2 (1 - q P(q)), q = a^2 <= (pi/2)^2, in two doubles. P, up to 1/12, is needed in
 * two doubles as well; what follows in it weighs less than 0.007. */
static inline sg_double2 sg_versine(sg_double2 a)
{
    sg_double2 q = sg_two_product(a.hi, a.hi);
    q.lo += 2.0 * a.hi * a.lo;
    double t = 2.0 / 1124000727777607680000.0;
    t = 2.0 / 2432902008176640000.0 - t * q.hi;
    t = 2.0 / 6402373705728000.0 - t * q.hi;
    t = 2.0 / 20922789888000.0 - t * q.hi;
    t = 2.0 / 87178291200.0 - t * q.hi;
    t = 2.0 / 479001600.0 - t * q.hi;
    t = 2.0 / 3628800.0 - t * q.hi;
    t = 2.0 / 40320.0 - t * q.hi;
    t = 2.0 / 720.0 - t * q.hi;
    sg_double2 p = sg_two_sum(0x1.5555555555555p-4, -t * q.hi);
    p.lo += 0x1.5555555555555p-58;
    sg_double2 pq = sg_two_product(p.hi, q.hi);
    pq.lo += p.hi * q.lo + p.lo * q.hi;
    sg_double2 rest = sg_two_sum(1.0, -pq.hi);
    rest.lo -= pq.lo;
    sg_double2 value = sg_two_product(0.5 * q.hi, rest.hi);
    value.lo += 0.5 * (q.hi * rest.lo + q.lo * rest.hi);
    return value;
}

static inline sg_direction sg_direction_of_angle(double beta)
{
    /* beta - pi/2 in two doubles, from three of pi, because pi/2 is not a double and all of the
     * difference may lie in what the first one leaves */
    sg_double2 coarse = sg_two_sum(beta, -0.5 * SG_PI_HI);
    sg_double2 fine = sg_two_sum(coarse.lo, -0.5 * SG_PI_LO);
    sg_double2 offset = sg_two_sum(coarse.hi, fine.hi);
    offset.lo += fine.lo - 0.5 * SG_PI_REST;
    sg_double2 a = {fabs(offset.hi), offset.lo * copysign(1.0, offset.hi)};
    double from_pi = (SG_PI_HI - beta) + SG_PI_LO;
    double delta = beta < from_pi ? beta : from_pi;
    double y = a.hi < delta ? a.hi : delta, y2 = y * y; /* at most pi/4 */
    double sine = 1.0 / 355687428096000.0;
    sine = sine * y2 - 1.0 / 1307674368000.0;
    sine = sine * y2 + 1.0 / 6227020800.0;
    sine = sine * y2 - 1.0 / 39916800.0;
    sine = sine * y2 + 1.0 / 362880.0;
    sine = sine * y2 - 1.0 / 5040.0;
    sine = sine * y2 + 1.0 / 120.0;
    sine = sine * y2 - 1.0 / 6.0;
    sine = y + y * y2 * sine;
    double versine = -1.0 / 6402373705728000.0;
    versine = versine * y2 + 1.0 / 20922789888000.0;
    versine = versine * y2 - 1.0 / 87178291200.0;
    versine = versine * y2 + 1.0 / 479001600.0;
    versine = versine * y2 - 1.0 / 3628800.0;
    versine = versine * y2 + 1.0 / 40320.0;
    versine = versine * y2 - 1.0 / 720.0;
    versine = versine * y2 + 1.0 / 24.0;
    versine = y2 * (0.5 - y2 * versine); /* 1 - cos y */
    /* one selection, and products with 0 and 1, because several would become a branch */
    double near = a.hi < delta ? 1.0 : 0.0, far = 1.0 - near;
    sg_direction d;
    d.sine = near * sine + far * (1.0 - versine);
    d.cosine = near * (1.0 - versine) + far * sine;
    d.one_minus_sine = near * (1.0 - sine) + far * versine;
    d.pole_sine = sqrt(0.5 * d.one_minus_sine);
    d.one_minus_cosine = sg_versine(a);
    d.z = copysign(d.sine, -offset.hi);
    return d;
}

/* e^-E, E = lambda (1 - cos a). Powers of 2 keep the splitting of a huge lambda and the product
 * from overflowing. */
static inline double sg_horizon_factor(double lambda, const sg_direction *d)
{
    sg_double2 exponent = sg_two_product(lambda * 0x1p-100, d->one_minus_cosine.hi * 0x1p90);
    double lo = exponent.lo + (lambda * 0x1p-100) * (d->one_minus_cosine.lo * 0x1p90);
    return sg_exp_minus(exponent.hi * 0x1p10, lo * 0x1p10);
}

/* The upper end of the integral in y: the pole, or where u = 40, which is a quadratic equation
 * in the tangent of half the angle. */
static inline double sg_cut(double lambda, const sg_direction *d)
{
    double y = 40.0 / (lambda > 1.0 ? lambda : 1.0);
    double under = d->sine * d->sine + y * (2.0 * d->cosine - y);
    under = 0.5 * (under + fabs(under)); /* where it is negative, this branch is not taken */
    double tangent = y / (d->sine + sqrt(under));
    double cut = tangent / sqrt(1.0 + tangent * tangent);
    return lambda * d->cosine <= 40.0 ? d->pole_sine : cut;
}

/* The piecewise polynomial of bessel_table.inc at r in [0, 1/8]. The table holds one row for each
 * power, so that a lookup is one index into a fixed array, which vectorises as a gather. */
static inline double sg_piece(const double table[SG_BESSEL_DEGREE + 1][SG_BESSEL_PIECES], double r)
{
    double place = r * (double)(SG_BESSEL_SHIFT * SG_BESSEL_PIECES);
    /* a factor just below 1, so that the end of the range falls to the last piece without a
     * selection, which compilers turn into a branch */
    double piece = ((place * (1.0 - 0x1p-20) - 0.5) + SG_ROUND) - SG_ROUND;
    double y = 2.0 * (place - piece) - 1.0;
    sg_bits shifted;
    shifted.value = piece + SG_ROUND;
    int64_t index = shifted.bits - SG_ROUND_BITS;
    double value = table[8][index];
    value = value * y + table[7][index];
    value = value * y + table[6][index];
    value = value * y + table[5][index];
    value = value * y + table[4][index];
    value = value * y + table[3][index];
    value = value * y + table[2][index];
    value = value * y + table[1][index];
    return value * y + table[0][index];
}

/* e^-x (I0(x) - I1(x)/x) and e^-x I0(x), put together from the two tables. */
static inline double sg_bessel_even_scaled(double x)
{
    double r = 1.0 / (x + (double)SG_BESSEL_SHIFT), ratio = x * r;
    return ratio * ratio * sqrt(r) * sg_piece(sg_bessel_even, r) + 0.5 * sg_exp_minus(x, 0.0);
}

static inline double sg_bessel_i0_scaled(double x)
{
    double r = 1.0 / (x + (double)SG_BESSEL_SHIFT);
    return sg_bessel_even_scaled(x) + r * sqrt(r) * sg_piece(sg_bessel_odd, r);
}

/* Integrand of A_h at y, less a factor 4, and of H, less a factor 2: e^-u times the source,
 * times what the change of variable brings. Both are written with x r, which cannot overflow. */
static inline double sg_even_node(double lambda, double sine, double cosine, double y)
{
    double u = lambda * (2.0 * y * (sine * sqrt(1.0 - y * y) + cosine * y));
    double x = lambda * cosine - u;
    x = 0.5 * x + 0.5 * fabs(x); /* max(x, 0) without a branch */
    double r = 1.0 / (x + (double)SG_BESSEL_SHIFT), ratio = x * r;
    return y * sg_exp_minus_small(u) * (ratio * ratio) * sqrt(r) * sg_piece(sg_bessel_even, r);
}

static inline double sg_odd_node(double lambda, double sine, double cosine, double y)
{
    double root = sqrt(1.0 - y * y);
    double u = lambda * (2.0 * y * (sine * root + cosine * y));
    double x = lambda * cosine - u;
    x = 0.5 * x + 0.5 * fabs(x); /* max(x, 0) without a branch */
    double r = 1.0 / (x + (double)SG_BESSEL_SHIFT);
    return sg_exp_minus_small(u) * (x * r) * sqrt(r) * sg_piece(sg_bessel_odd, r) / root;
}
#endif
