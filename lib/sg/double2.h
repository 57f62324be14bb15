/* double2.h: sums and products in two doubles, and exp of a negative number, all free of branches
 * and calls so that loops over them vectorise. Internal to libsg. */
#ifndef SG_DOUBLE2_H
#define SG_DOUBLE2_H

#include <math.h>
#include <stdint.h>
#include <string.h>

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

/* e^(n ln 2 - hi - lo), |that| < 0.35, with n the integer nearest to hi/ln 2, left in *bits as a
 * 64-bit integer: adding 1.5 2^52 rounds to an integer and leaves it in the low bits. */
static inline double sg_exp_reduced(double hi, double lo, int64_t *bits)
{
    const double ln2_hi = 0x1.62e42feep-1, ln2_lo = 0x1.a39ef35793c76p-33, round = 0x1.8p52;
    double shifted = hi * 1.44269504088896340736 + round;
    double n = shifted - round;
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
    memcpy(bits, &shifted, sizeof *bits);
    *bits -= 0x4338000000000000; /* the bits of 1.5 2^52 */
    return 1.0 + (r + r * r * q);
}

/* 2^-n for n in [-1023, 1022] */
static inline double sg_power_minus(int64_t n)
{
    int64_t bits = (int64_t)((uint64_t)(1023 - n) << 52);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* e^-u for u in [0, 700] */
static inline double sg_exp_minus_small(double u)
{
    int64_t n;
    double value = sg_exp_reduced(u, 0.0, &n);
    return value * sg_power_minus(n);
}

/* e^-(hi + lo) for hi >= 0 and lo below an ulp of hi; 0 from 746 on. */
static inline double sg_exp_minus(double hi, double lo)
{
    int64_t n;
    double value = sg_exp_reduced(hi < 800.0 ? hi : 800.0, lo, &n);
    /* in two steps, because 2^-1074 is below the normal range */
    return value * sg_power_minus(n >> 1) * sg_power_minus(n - (n >> 1));
}

#endif
