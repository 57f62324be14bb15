/* report_speed.h: how fast the reference is, and which driver would run the shaders. */
#ifndef BENCH_REPORT_SPEED_H
#define BENCH_REPORT_SPEED_H

#include <stddef.h>

typedef struct report_speeds {
    double single, batch; /* A_h a second on one core */
} report_speeds;

/* Measured at the first call, on an otherwise idle process; later calls return the same. */
report_speeds report_speed(void);

/* "llvmpipe ... , Mesa 22.3.6", or why there is none. */
void report_driver(char *text, size_t size);

#endif
