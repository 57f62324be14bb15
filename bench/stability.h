/* stability.h: where a method fails. Scans lambda and cos_theta densely, and finds by bisection the
 * sharpnesses between which a value is off, negative, above 1, infinite or NaN.
 *
 * Precisions: double, float and half in C, and `device`: the function of shaders/sg.glsl on a
 * Vulkan device. Arguments are numbers that the precision holds, and the truth is the reference at
 * those; what is found is the method's failure, not that of rounding its arguments.
 *
 * Model error and rounding error: `error_...` compares with the reference, `rounding_...` with the
 * next wider precision of the same text at the same arguments (float, half and the device with
 * double, double with long double where that is wider). */
#ifndef BENCH_STABILITY_H
#define BENCH_STABILITY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "sg.h"

typedef enum stability_precision {
    STABILITY_F64,
    STABILITY_F32,
    STABILITY_F16,
    STABILITY_DEVICE,
    STABILITY_PRECISIONS
} stability_precision;

const char *stability_precision_name(stability_precision precision); /* "f64", ..., "device" */
/* A number as the precision holds it. */
double stability_rounded(stability_precision precision, double value);

/* ---- What is scanned ------------------------------------------------------------------------- */

typedef struct stability_subject stability_subject;

/* Values at n points, with arguments that the precision holds. False after one line. */
typedef bool (*stability_function)(const stability_subject *subject, size_t n, const double *lambda,
                                   const double *cos_theta, double *out);

struct stability_subject {
    const char *id;
    stability_precision precision;
    stability_function value;
    stability_function truth;   /* NULL: the reference L */
    stability_function twin;    /* the same text, wider; may be NULL */
    stability_function flushed; /* the same with denormals flushed; may be NULL */
    stability_function A_h;     /* the other quantity; may be NULL */
    const void *context;
    bool any_size; /* above 1 is no failure */
    bool device;   /* is called from one thread at a time, with many points at once */
};

/* The method of the registry, or of a test, in C. False where the precision is not there. */
bool stability_method_subject(const sg_method *method, stability_precision precision,
                              stability_subject *subject);

/* ---- What is found --------------------------------------------------------------------------- */

/* Between lambda_from and lambda_to, both failing, the failure occurs for some cos_theta; gaps of
 * less than a factor of 10 are not told apart. worst: the largest error, or the value farthest
 * out. kind:
 *   error_1e-4, error_1e-3, error_1e-2   |value - reference| is larger
 *   rounding_1e-6 (not f16), rounding_1e-3, rounding_1e-2   |value - twin| is larger
 *   negative, above_one, infinite, nan   of L
 *   A_h_negative, A_h_infinite, A_h_nan  of A_h
 *   flushed           flushing denormals changes L by more than 1e-6
 *   limit_at_infinity L at an infinite sharpness is not max(cos_theta, 0), to 1e-6 (f16: 1e-3)
 *   nan_input         NaN as an argument gives a number, which is `worst` */
typedef struct stability_row {
    const char *method, *precision, *kind;
    double lambda_from, lambda_to, worst, worst_lambda, worst_cos_theta;
} stability_row;

typedef struct stability_table {
    stability_row *rows;
    size_t count, capacity;
} stability_table;

void stability_table_free(stability_table *table);

typedef struct stability_grid stability_grid;

/* quick: a quarter of the sharpnesses, a third of the cosines. Computes the truth on all cores. */
stability_grid *stability_grid_new(stability_precision precision, bool quick);
void stability_grid_free(stability_grid *grid); /* NULL is fine */

/* Where a piecewise formula goes from one piece to the next: a sharpness on either side, with
 * cosines that matter there (where the seam depends on both). */
enum { STABILITY_SEAM_COSINES = 8 };
typedef struct stability_seam {
    double lambda, cos_theta[STABILITY_SEAM_COSINES];
    size_t count;
} stability_seam;

typedef struct stability_seams {
    stability_seam *list;
    size_t count, capacity;
} stability_seams;

/* stability_seams.c: found in the values of a function of (lambda, cos_theta) in double: where it
 * or its slope jumps, by bisection. Adds both sides of each, as the precision holds them. */
void stability_seams_in_values(double (*L)(double, double), stability_precision precision,
                               stability_seams *seams);
void stability_seams_free(stability_seams *seams);

/* Adds the rows of one subject. The grid is of the subject's precision (device: of float); seams
 * may be NULL. False after one line. */
bool stability_scan(const stability_subject *subject, const stability_grid *grid,
                    const stability_seams *seams, stability_table *table);

/* ---- Failure maps ---------------------------------------------------------------------------- */

/* Columns: sharpness, logarithmic from 1e-12 to 1e12; rows: beta from 0 (top) to pi. */
enum { STABILITY_MAP_WIDTH = 192, STABILITY_MAP_HEIGHT = 96 };
extern const double stability_map_lambda_min, stability_map_lambda_max;

typedef enum stability_mark {
    STABILITY_FINE,
    STABILITY_NEGATIVE,  /* below -1e-6 */
    STABILITY_ABOVE_ONE, /* above 1 + 1e-6 (half: by more than a rounding) */
    STABILITY_INFINITE,
    STABILITY_NAN,
    STABILITY_MARKS
} stability_mark;

typedef struct stability_map {
    float error[STABILITY_MAP_HEIGHT * STABILITY_MAP_WIDTH]; /* log10 of |L - reference|, at least
                                                                -17; inf, NaN where L is */
    float mark[STABILITY_MAP_HEIGHT * STABILITY_MAP_WIDTH];  /* a stability_mark */
} stability_map;

bool stability_map_make(const stability_subject *subject, stability_map *map);
/* The colour of an error (log10; the scale goes from -8 to 0), or of a mark that is not
 * STABILITY_FINE: what the PNG is painted with, for the legend of a page. */
void stability_color(double log10_error, stability_mark mark, uint8_t rgb[3]);
/* PATH.exr (half; channels Y: error, mark) and PATH.png. False after one line. */
bool stability_map_write(const stability_map *map, const char *path);

/* ---- Everything ------------------------------------------------------------------------------ */

typedef struct stability_options {
    const char *only;   /* a method's id, or NULL */
    const char *device; /* part of the Vulkan device's name; NULL: no device */
    const char *out;    /* folder for failures.csv, half.csv, smoothness.csv, maps; or NULL */
    bool quick;
} stability_options;

typedef struct stability_result {
    stability_table failures;
    char device[600];    /* name and version of the device, "" where there is none, */
    char no_device[256]; /* and why */
} stability_result;

/* What half leaves of a method: the widest range of sharpnesses within which its error in half
 * stays below 1e-2 (at every cosine), by the rows of a table. From 0: down to 0; to inf: up to
 * 65504 and, where that becomes infinite, beyond. False where there is none. */
bool stability_half_range(const stability_table *table, const char *method, double *from,
                          double *to);

/* Scans the registry and the operations, and writes the files. False after one line. */
bool stability_run(const stability_options *options, stability_result *result);
void stability_result_free(stability_result *result);

/* The command `sgfit stability`. */
int stability_command(int argc, char **argv);

#endif
