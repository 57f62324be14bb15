/* eval_stream.h: rows in, the same rows with values out. */
#ifndef FIT_EVAL_STREAM_H
#define FIT_EVAL_STREAM_H

#include <stdbool.h>
#include <stdio.h>

#include "fit/evaluator.h"

typedef struct eval_format {
    const char *column; /* name of the last column */
    bool json;          /* an array of objects instead of CSV */
} eval_format;

/* Reads CSV whose header names lambda and beta or cos_theta; sets evaluator->by_beta. Returns the
 * exit status, after one line where that is not 0. */
int eval_stream(evaluator *evaluator, const eval_format *format, FILE *in, const char *name);

/* One point, written as the stream would write it. */
int eval_point(const evaluator *evaluator, const eval_format *format, double lambda, double angle);

#endif
