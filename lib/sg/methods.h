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

/* What a text computes natively is "value"; the other quantity follows by the integral A.
 * Two macros a quantity, chosen by the word in methods.inc. */
#define SG_A_h_FROM_A_h(value, lambda, cos_theta) (value)
#define SG_L_FROM_A_h(value, lambda, cos_theta)   SG_NAME(sg_L_from_A_h)(value, lambda, cos_theta)
#define SG_L_FROM_L(value, lambda, cos_theta)     (value)
#define SG_A_h_FROM_L(value, lambda, cos_theta)   SG_NAME(sg_A_h_from_L)(value, lambda)

#define SG_CORES(ID, FORM, NATIVE)                                                                 \
    SG_INLINE SG_REAL SG_NAME(core_A_h_##ID)(SG_REAL lambda, SG_REAL cos_theta)                    \
    {                                                                                              \
        SG_REAL value = SG_NAME(form_##FORM)(lambda, cos_theta, SG_NAME(sg_coefficients_##ID));    \
        return SG_A_h_FROM_##NATIVE(value, lambda, cos_theta);                                     \
    }                                                                                              \
    SG_INLINE SG_REAL SG_NAME(core_L_##ID)(SG_REAL lambda, SG_REAL cos_theta)                      \
    {                                                                                              \
        SG_REAL value = SG_NAME(form_##FORM)(lambda, cos_theta, SG_NAME(sg_coefficients_##ID));    \
        return SG_L_FROM_##NATIVE(value, lambda, cos_theta);                                       \
    }

/* What single functions are compiled for besides the common instruction set; methods_f16.c. */
#ifndef SG_SINGLE_CLONES
#define SG_SINGLE_CLONES
#endif

/* ARGUMENT is the type that callers pass and get: float for half. */
#define SG_SINGLE(QUANTITY, ID, ARGUMENT)                                                          \
    SG_HIDDEN ARGUMENT SG_NAME(sg_##QUANTITY##_##ID)(ARGUMENT lambda, ARGUMENT cos_theta);         \
    SG_SINGLE_CLONES ARGUMENT SG_NAME(sg_##QUANTITY##_##ID)(ARGUMENT lambda, ARGUMENT cos_theta)   \
    {                                                                                              \
        return (ARGUMENT)SG_NAME(core_##QUANTITY##_##ID)((SG_REAL)lambda, (SG_REAL)cos_theta);     \
    }

#define SG_BATCH(QUANTITY, ID)                                                                     \
    SG_HIDDEN void SG_NAME(sg_##QUANTITY##_batch_##ID)(size_t n, const SG_REAL *restrict lambda,   \
                                                       const SG_REAL *restrict cos_theta,          \
                                                       SG_REAL *restrict out);                     \
    SG_CLONES void SG_NAME(sg_##QUANTITY##_batch_##ID)(size_t n, const SG_REAL *restrict lambda,   \
                                                       const SG_REAL *restrict cos_theta,          \
                                                       SG_REAL *restrict out)                      \
    {                                                                                              \
        SG_LOOP                                                                                    \
        for (size_t i = 0; i < n; i++)                                                             \
            out[i] = SG_NAME(core_##QUANTITY##_##ID)(lambda[i], cos_theta[i]);                     \
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
