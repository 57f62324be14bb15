/* stability_subjects.c: the methods of the registry as subjects of the scan, in C. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "stability_private.h"

#if defined(__SSE__)
#include <xmmintrin.h>
/* Flushes results to zero and takes denormal operands as zero, as graphics hardware does. Returns
 * the mode before. */
static unsigned flush_denormals(void)
{
    unsigned before = _mm_getcsr();
    _mm_setcsr(before | 0x8040u);
    return before;
}
static void flush_no_more(unsigned before)
{
    _mm_setcsr(before);
}
enum { CAN_FLUSH = 1 };
#else
static unsigned flush_denormals(void)
{
    return 0;
}
static void flush_no_more(unsigned before)
{
    (void)before;
}
enum { CAN_FLUSH = 0 };
#endif

static bool wide(double (*f)(double, double), size_t n, const double *lambda,
                 const double *cos_theta, double *out)
{
    for (size_t i = 0; i < n; i++)
        out[i] = f(lambda[i], cos_theta[i]);
    return true;
}

static bool narrow(float (*f)(float, float), size_t n, const double *lambda,
                   const double *cos_theta, double *out)
{
    for (size_t i = 0; i < n; i++)
        out[i] = (double)f((float)lambda[i], (float)cos_theta[i]);
    return true;
}

#define SUBJECT_FUNCTION(name, how, field)                                                         \
    static bool name(const stability_subject *subject, size_t n, const double *lambda,             \
                     const double *cos_theta, double *out)                                         \
    {                                                                                              \
        return how(((const sg_method *)subject->context)->field, n, lambda, cos_theta, out);       \
    }
SUBJECT_FUNCTION(L_f64, wide, L_f64)
SUBJECT_FUNCTION(A_h_f64, wide, A_h_f64)
SUBJECT_FUNCTION(L_f32, narrow, L_f32)
SUBJECT_FUNCTION(A_h_f32, narrow, A_h_f32)
SUBJECT_FUNCTION(L_f16, narrow, L_f16)
SUBJECT_FUNCTION(A_h_f16, narrow, A_h_f16)

static bool L_long(const stability_subject *subject, size_t n, const double *lambda,
                   const double *cos_theta, double *out)
{
    return wide(stability_long_L(subject->id), n, lambda, cos_theta, out);
}

static bool L_f32_flushed(const stability_subject *subject, size_t n, const double *lambda,
                          const double *cos_theta, double *out)
{
    unsigned before = flush_denormals();
    L_f32(subject, n, lambda, cos_theta, out);
    flush_no_more(before);
    return true;
}

bool stability_method_subject(const sg_method *method, stability_precision precision,
                              stability_subject *subject)
{
    *subject = (stability_subject){.id = method->id, .precision = precision, .context = method};
    switch (precision) {
    case STABILITY_F64:
        subject->value = L_f64;
        subject->A_h = A_h_f64;
        /* a test's own method may have the id of one that is compiled in, or none */
        if (sg_method_find(method->id) == method && stability_long_L(method->id))
            subject->twin = L_long;
        return true;
    case STABILITY_F32:
        subject->value = L_f32;
        subject->A_h = A_h_f32;
        subject->twin = L_f64;
        subject->flushed = CAN_FLUSH ? L_f32_flushed : NULL;
        return true;
    case STABILITY_F16:
        subject->value = L_f16;
        subject->A_h = A_h_f16;
        subject->twin = L_f64;
        return method->L_f16 != NULL;
    default:
        return false;
    }
}
