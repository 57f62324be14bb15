/* integral_batch.h: the batch evaluation, once for each kind of processor. Internal to libsg. */
#ifndef SG_INTEGRAL_BATCH_H
#define SG_INTEGRAL_BATCH_H

#include <stddef.h>

typedef enum sg_batch_quantity { SG_BATCH_A_H, SG_BATCH_A_H_COS, SG_BATCH_L_COS } sg_batch_quantity;

/* direction: beta for SG_BATCH_A_H, else cos_theta */
void sg_batch_baseline(sg_batch_quantity what, size_t n, const double *lambda,
                       const double *direction, double *out);
void sg_batch_avx2(sg_batch_quantity what, size_t n, const double *lambda, const double *direction,
                   double *out);

#endif
