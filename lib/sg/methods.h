/* methods.h: stamps the registry's functions at one precision. Private; included by
 * methods_*.c after real.h, and by method.c for the declarations alone.
 *
 * Generated lists (written by `sgfit emit`):
 *   forms.inc     the texts: SG_NAME(form_FORM)(lambda, cos_theta, k) and their helpers
 *   methods.inc   SG_METHOD(ID, FORM, NATIVE, coefficient, ...)  for every method
 *   registry.inc  SG_FORM_ROW(FORM, NATIVE, COUNT, names) and SG_METHOD_ROW(ID, FORM, ...)
 */
#ifndef SG_METHODS_H
#define SG_METHODS_H

#include "sg.h"

#if defined(__GNUC__)
#define SG_HIDDEN __attribute__((visibility("hidden")))
#else
#define SG_HIDDEN
#endif

/* The quantity that the lists call A_h or L. */
#define SG_NATIVE_A_h SG_A_H
#define SG_NATIVE_L   SG_L

#ifdef SG_PRECISION

/* What a text computes natively is "value"; the other quantity follows by the integral A. */
#define SG_L_FROM_A_h(value, lambda, cos_theta) SG_NAME(sg_L_from_A_h)(value, lambda, cos_theta)
#define SG_A_h_FROM_L(value, lambda, cos_theta) SG_NAME(sg_A_h_from_L)(value, lambda)

/* What single functions are compiled for besides the common instruction set; methods_f16.c. */
#ifndef SG_SINGLE_CLONES
#define SG_SINGLE_CLONES
#endif

/* The native quantity is stamped from the text; the other one calls it and converts, so that every
 * text is compiled once for single and once for batch calls: half the code, the same bits.
 * ARGUMENT is the type that callers pass and get: float for half. */
#define SG_SINGLE_SIGNATURE(QUANTITY, ID, ARGUMENT)                                                \
    ARGUMENT SG_NAME(sg_##QUANTITY##_##ID)(ARGUMENT lambda, ARGUMENT cos_theta)

#define SG_SINGLE_NATIVE(QUANTITY, ID, FORM, ARGUMENT)                                             \
    SG_HIDDEN SG_SINGLE_SIGNATURE(QUANTITY, ID, ARGUMENT);                                         \
    SG_SINGLE_CLONES SG_SINGLE_SIGNATURE(QUANTITY, ID, ARGUMENT)                                   \
    {                                                                                              \
        return (ARGUMENT)SG_NAME(form_##FORM)((SG_REAL)lambda, (SG_REAL)cos_theta,                 \
                                              SG_NAME(sg_coefficients_##ID));                      \
    }

#define SG_SINGLE_OTHER(QUANTITY, NATIVE, ID, ARGUMENT)                                            \
    SG_HIDDEN SG_SINGLE_SIGNATURE(QUANTITY, ID, ARGUMENT);                                         \
    SG_SINGLE_CLONES SG_SINGLE_SIGNATURE(QUANTITY, ID, ARGUMENT)                                   \
    {                                                                                              \
        SG_REAL value = (SG_REAL)SG_NAME(sg_##NATIVE##_##ID)(lambda, cos_theta);                   \
        return (ARGUMENT)SG_##QUANTITY##_FROM_##NATIVE(value, (SG_REAL)lambda,                     \
                                                       (SG_REAL)cos_theta);                        \
    }

#define SG_BATCH_SIGNATURE(QUANTITY, ID)                                                           \
    void SG_NAME(sg_##QUANTITY##_batch_##ID)(size_t n, const SG_REAL *restrict lambda,             \
                                             const SG_REAL *restrict cos_theta,                    \
                                             SG_REAL *restrict out)

#define SG_BATCH_NATIVE(QUANTITY, ID, FORM)                                                        \
    SG_HIDDEN SG_BATCH_SIGNATURE(QUANTITY, ID);                                                    \
    SG_CLONES SG_BATCH_SIGNATURE(QUANTITY, ID)                                                     \
    {                                                                                              \
        SG_LOOP                                                                                    \
        for (size_t i = 0; i < n; i++)                                                             \
            out[i] = SG_NAME(form_##FORM)(lambda[i], cos_theta[i], SG_NAME(sg_coefficients_##ID)); \
    }

#define SG_BATCH_OTHER(QUANTITY, NATIVE, ID)                                                       \
    SG_HIDDEN SG_BATCH_SIGNATURE(QUANTITY, ID);                                                    \
    SG_BATCH_SIGNATURE(QUANTITY, ID)                                                               \
    {                                                                                              \
        SG_NAME(sg_##NATIVE##_batch_##ID)(n, lambda, cos_theta, out);                              \
        SG_NAME(sg_batch_##QUANTITY##_from_##NATIVE)(n, lambda, cos_theta, out);                   \
    }

#define SG_SINGLES_A_h(ID, FORM, ARGUMENT)                                                         \
    SG_SINGLE_NATIVE(A_h, ID, FORM, ARGUMENT)                                                      \
    SG_SINGLE_OTHER(L, A_h, ID, ARGUMENT)
#define SG_SINGLES_L(ID, FORM, ARGUMENT)                                                           \
    SG_SINGLE_NATIVE(L, ID, FORM, ARGUMENT)                                                        \
    SG_SINGLE_OTHER(A_h, L, ID, ARGUMENT)
#define SG_BATCHES_A_h(ID, FORM)                                                                   \
    SG_BATCH_NATIVE(A_h, ID, FORM)                                                                 \
    SG_BATCH_OTHER(L, A_h, ID)
#define SG_BATCHES_L(ID, FORM)                                                                     \
    SG_BATCH_NATIVE(L, ID, FORM)                                                                   \
    SG_BATCH_OTHER(A_h, L, ID)

/* Once in each unit that has batch functions: the conversions that they share. */
#define SG_BATCH_CONVERSION(QUANTITY, NATIVE)                                                      \
    SG_CLONES static void SG_NAME(sg_batch_##QUANTITY##_from_##NATIVE)(                            \
        size_t n, const SG_REAL *restrict lambda, const SG_REAL *restrict cos_theta,               \
        SG_REAL *restrict out)                                                                     \
    {                                                                                              \
        (void)cos_theta;                                                                           \
        SG_LOOP                                                                                    \
        for (size_t i = 0; i < n; i++)                                                             \
            out[i] = SG_##QUANTITY##_FROM_##NATIVE(out[i], lambda[i], cos_theta[i]);               \
    }

#define SG_COEFFICIENTS(ID, ...)                                                                   \
    SG_HIDDEN extern const SG_REAL SG_NAME(sg_coefficients_##ID)[];                                \
    const SG_REAL SG_NAME(sg_coefficients_##ID)[] = {__VA_ARGS__};

#define SG_FORM_FUNCTION(FORM)                                                                     \
    SG_HIDDEN SG_REAL SG_NAME(sg_form_##FORM)(SG_REAL lambda, SG_REAL cos_theta,                   \
                                              const SG_REAL *coefficients);                        \
    SG_REAL SG_NAME(sg_form_##FORM)(SG_REAL lambda, SG_REAL cos_theta,                             \
                                    const SG_REAL *coefficients)                                   \
    {                                                                                              \
        return SG_NAME(form_##FORM)(lambda, cos_theta, coefficients);                              \
    }

#endif
#endif
