/* kinks.h: where a function of one variable, or its slope, jumps. */
#ifndef BENCH_KINKS_H
#define BENCH_KINKS_H

#include <stddef.h>

typedef double (*kink_function)(const void *context, double t);

typedef struct kink {
    double at;    /* t */
    double step;  /* the function's value above t less that below; 0 where none is to be seen */
    double slope; /* the same of its first derivative */
} kink;

/* Looks at `samples` places, uniform on [from, to], for second differences that stand out from
 * those around them, and bisects each. What is narrower than a sample is not seen. Up to `most`
 * kinks are stored, in order of t; their number. Where the function is not finite there are none.
 */
size_t kinks_find(kink_function f, const void *context, double from, double to, size_t samples,
                  kink *kinks, size_t most);

#endif
