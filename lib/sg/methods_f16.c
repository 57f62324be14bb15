/* methods_f16.c: every form and method in IEEE half, each operation rounded to it.
 *
 * Empty where the compiler has no _Float16 or keeps excess precision (methods.cmake asks): there
 * the registry's f16 pointers are NULL. Rounding float after each operation by hand would be
 * another text than the forms', so there is no such substitute. */
#include "sg.h"

#ifdef SG_HAVE_F16

#define SG_PRECISION 16
#include "real.h"

/* Where the processor converts between half and float by itself (F16C, part of x86-64-v3) this is
 * 14 times as fast as in software, to the same bits; contraction is off, so that the fused
 * multiply-add of that level changes nothing. */
#if defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__) && defined(__x86_64__) &&           \
    defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SG_SINGLE_CLONES __attribute__((target_clones("default", "arch=x86-64-v3")))
#endif
#include "methods.h"

#include "../../tables/out/forms.inc"

#define SG_METHOD(ID, FORM, NATIVE, ...)                                                           \
    SG_COEFFICIENTS(ID, __VA_ARGS__)                                                               \
    SG_SINGLES_##NATIVE(ID, FORM, float)
#include "../../tables/out/methods.inc"

/* Callers hold coefficients as float. */
#define SG_FORM_ROW(FORM, NATIVE, COUNT, ...)                                                      \
    SG_HIDDEN float sg_form_##FORM##_f16(float lambda, float cos_theta,                            \
                                         const float *coefficients);                               \
    float sg_form_##FORM##_f16(float lambda, float cos_theta, const float *coefficients)           \
    {                                                                                              \
        SG_REAL k[COUNT + 1] = {SG_K(0.0)};                                                        \
        for (int i = 0; i < COUNT; i++)                                                            \
            k[i] = (SG_REAL)coefficients[i];                                                       \
        return (float)form_##FORM##_f16((SG_REAL)lambda, (SG_REAL)cos_theta, k);                   \
    }
#define SG_METHOD_ROW(ID, FORM, TITLE, SOURCE, YEAR, VARIANT, LAMBDA_MIN, LAMBDA_MAX)
#include "../../tables/out/registry.inc"

#endif
