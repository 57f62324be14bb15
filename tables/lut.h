/* lut.h: the look-up table as files. */
#ifndef TABLES_LUT_H
#define TABLES_LUT_H

#include <stdbool.h>

#include "base/buffer.h"

typedef struct lut {
    buffer float_exr, half_exr; /* whole files */
    buffer readme;              /* what tables/out holds, with the measured errors of the table */
} lut;

bool lut_make(lut *made); /* false after one line */
void lut_free(lut *made);

#endif
