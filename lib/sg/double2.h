/* double2.h: sums and products in two doubles, and exp of a negative number, all free of branches
 * and calls so that loops over them vectorise. Internal to libsg. */
#ifndef SG_DOUBLE2_H
#define SG_DOUBLE2_H

#include <math.h>
#include <stdint.h>

typedef struct sg_double2 {
    double hi, lo;
} sg_double2;

static inline sg_double2 sg_two_sum(double a, double b)
{
    double sum = a + b, b_part = sum - a;
    return (sg_double2){sum, (a - (sum - b_part)) + (b - b_part)};
}

/* a*b exactly (Dekker), for factors below 2^970 */
static inline sg_double2 sg_two_product(double a, double b)
{
    double big_a = a * 134217729.0, big_b = b * 134217729.0; /* 2^27 + 1 */
    double a_hi = big_a - (big_a - a), b_hi = big_b - (big_b - b);
    double a_lo = a - a_hi, b_lo = b - b_hi;
    double product = a * b;
    return (sg_double2){product,
                        ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

/* The 64 bits of a double; a union, because loops over it vectorise. */
typedef union sg_bits {
    double value;
    int64_t bits;
} sg_bits;

/* Adding 1.5 2^52 to a double below 2^51 rounds it to an integer and leaves that in the low bits.
 */
#define SG_ROUND      0x1.8p52
#define SG_ROUND_BITS INT64_C(0x4338000000000000)

/* e^(n ln 2 - hi - lo), |that| < 0.35, and n, the integer nearest to hi/ln 2. */
typedef struct sg_exp_parts {
    double value;
    int64_t n;
} sg_exp_parts;

static inline sg_exp_parts sg_exp_reduced(double hi, double lo)
{
    const double ln2_hi = 0x1.62e42feep-1, ln2_lo = 0x1.a39ef35793c76p-33;
    sg_bits shifted;
    shifted.value = hi * 1.44269504088896340736 + SG_ROUND;
    double n = shifted.value - SG_ROUND;
    double r = ((n * ln2_hi - hi) + n * ln2_lo) - lo;
    double q = 1.0 / 6227020800.0;
    q = q * r + 1.0 / 479001600.0;
    q = q * r + 1.0 / 39916800.0;
    q = q * r + 1.0 / 3628800.0;
    q = q * r + 1.0 / 362880.0;
    q = q * r + 1.0 / 40320.0;
    q = q * r + 1.0 / 5040.0;
    q = q * r + 1.0 / 720.0;
    q = q * r + 1.0 / 120.0;
    q = q * r + 1.0 / 24.0;
    q = q * r + 1.0 / 6.0;
    q = q * r + 0.5;
    return (sg_exp_parts){1.0 + (r + r * r * q), shifted.bits - SG_ROUND_BITS};
}

/* 2^-n for n in [-1023, 1022] */
static inline double sg_power_minus(int64_t n)
{
    sg_bits power;
    power.bits = (int64_t)((uint64_t)(1023 - n) << 52);
    return power.value;
}

/* e^-u for u in [0, 700] */
static inline double sg_exp_minus_small(double u)
{
    sg_exp_parts parts = sg_exp_reduced(u, 0.0);
    return parts.value * sg_power_minus(parts.n);
}

/* e^-(hi + lo) for hi >= 0 and |lo| below 1e-10, which it is cut to; 0 from hi = 746 on. */
static inline double sg_exp_minus(double hi, double lo)
{
    lo = lo < 1e-10 ? lo : 1e-10;
    lo = lo > -1e-10 ? lo : -1e-10;
    sg_exp_parts parts = sg_exp_reduced(hi < 800.0 ? hi : 800.0, lo);
    /* in two steps, because 2^-1074 is below the normal range */
    int64_t half = (int64_t)((uint64_t)parts.n >> 1);
    return parts.value * sg_power_minus(half) * sg_power_minus(parts.n - half);
}

#endif
