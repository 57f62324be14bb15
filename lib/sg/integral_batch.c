/* integral_batch.c: the batch entry points, which pick the widest unit that the processor runs. */
#define SG_BATCH(name) name##_baseline
#include "integral_batch.inc"

#include "sg.h"

static void run(sg_batch_quantity what, size_t n, const double *lambda, const double *direction,
                double *out)
{
#ifdef SG_HAVE_AVX2
    if (__builtin_cpu_supports("avx2")) {
        sg_batch_avx2(what, n, lambda, direction, out);
        return;
    }
#endif
    sg_batch_baseline(what, n, lambda, direction, out);
}

void sg_A_h_batch(size_t n, const double *lambda, const double *beta, double *out)
{
    run(SG_BATCH_A_H, n, lambda, beta, out);
}

void sg_A_h_cos_batch(size_t n, const double *lambda, const double *cos_theta, double *out)
{
    run(SG_BATCH_A_H_COS, n, lambda, cos_theta, out);
}

void sg_L_cos_batch(size_t n, const double *lambda, const double *cos_theta, double *out)
{
    run(SG_BATCH_L_COS, n, lambda, cos_theta, out);
}
