/* integral_batch_avx2.c: the batch evaluation for x86-64 processors with AVX2; compiled with
 * -mavx2. */
#define SG_BATCH(name) name##_avx2
#include "integral_batch.inc"
