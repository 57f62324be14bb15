/* cost.h: what a method costs: instructions of a GPU that need not be there, nanoseconds on this
 * CPU, and time on the Vulkan device at hand as a ratio. Private to bench, but for `choose`.
 *
 * What cannot be measured on this machine (no RADV, no such device) is NaN. */
#ifndef BENCH_COST_H
#define BENCH_COST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "sg.h"

/* ---- Subjects: a method of the registry, or a look-up table, and the text that is measured ------
 */

typedef struct cost_texture {
    uint32_t width, height; /* height 0: one-dimensional */
    int channels;
    bool half;
    float *texels;
} cost_texture;

typedef struct cost_subject {
    char *id;
    sg_quantity quantity;
    const sg_method *method; /* NULL for a table */
    char *glsl;              /* float f(float lambda, float cos_theta) and what it needs; of a
                                published method as its authors ship it (cost_peers.c) */
    char *include;           /* the same as sg.glsl has it, where that differs; else NULL */
    cost_texture texture;    /* at binding 2 of set 0; texels NULL: none */
    int fetches;
} cost_subject;

typedef struct cost_subjects {
    cost_subject *list; /* L, then A_h, of each method in the registry's order, then the tables */
    size_t count;
} cost_subjects;

/* cost_subjects.c: every method of the registry, with its shader text as `sgfit emit` writes it
 * from the source tree. only: that id alone, or NULL. False after one line. */
bool cost_subjects_read(cost_subjects *subjects, const char *only);
/* cost_peers.c: a copy of a text as emitted, with the helpers of bench/peers in the place of ours.
 * NULL after one line. */
char *cost_as_shipped(const char *glsl);
void cost_subjects_free(cost_subjects *subjects);
/* cost_tables.c: the look-up tables among the subjects; forms: for the helpers that they need. */
struct form_list;
size_t cost_table_count(void);
const char *cost_table_id(size_t index);
bool cost_table_subject(size_t index, const struct form_list *forms, sg_quantity quantity,
                        cost_subject *subject);
const char *cost_quantity_name(sg_quantity quantity); /* "L", "A_h" */

/* ---- cost_gpu.c: instructions ------------------------------------------------------------------
 */

enum { COST_FAMILIES = 3 };
extern const char *const cost_families[COST_FAMILIES]; /* navi21, gfx1100, vega10 */

/* See lib/gpu/gpu.h, "What a function costs", for the wrappers that these come from. */
typedef struct cost_count {
    double instructions;       /* of one evaluation, without the wrapper */
    double inverse_throughput; /* the same, in the compiler's cycles; partly hidden by memory */
    double slope;              /* cycles of one more evaluation */
    double slope_instructions;
    double vgprs;              /* registers of the whole shader of one */
    double pixel_instructions; /* of what is left where lambda is known: once a pixel, */
    double pixel_slope;        /* and the cycles of one more of that */
} cost_count;

extern const cost_count cost_unknown; /* all NaN */

typedef struct cost_counter cost_counter;

/* NULL where the family cannot be counted here, after one line in reason (size 256). */
cost_counter *cost_counter_open(const char *family, char reason[256]);
void cost_counter_close(cost_counter *counter);               /* NULL is fine */
const char *cost_counter_driver(const cost_counter *counter); /* "radv Mesa 22.3.6" */
/* The source as in cost_subject.glsl. False after one line on standard error. */
bool cost_counter_run(cost_counter *counter, const char *name, const char *glsl, cost_count *count);

/* ---- cost_cpu.c: nanoseconds -------------------------------------------------------------------
 */

/* The arguments that everything is timed with: sharpnesses logarithmic, cosines uniform, a
 * low-discrepancy sequence, the same in every run. They fit the second-level cache together with
 * the results. */
enum { COST_POINTS = 4096 };
extern const double cost_lambda_min, cost_lambda_max; /* cos_theta: [-1, 1] */

typedef struct cost_points {
    double lambda[COST_POINTS], cos_theta[COST_POINTS];
    float lambda_f32[COST_POINTS], cos_theta_f32[COST_POINTS];
} cost_points;

void cost_points_fill(cost_points *points);

/* Nanoseconds of one evaluation: the fastest and the median of the samples, warmed up. */
typedef struct cost_time {
    double best, median;
} cost_time;

enum { COST_SAMPLES = 15, COST_QUICK_SAMPLES = 5 };

/* Single: a call through a pointer for each value, as a program makes it. Batch: one call. */
cost_time cost_time_f32(const cost_points *points, float (*f)(float, float), int samples);
cost_time cost_time_f64(const cost_points *points, double (*f)(double, double), int samples);
cost_time cost_time_batch_f32(const cost_points *points,
                              void (*f)(size_t, const float *, const float *, float *),
                              int samples);
cost_time cost_time_batch_f64(const cost_points *points,
                              void (*f)(size_t, const double *, const double *, double *),
                              int samples);

/* ---- cost_device.c: the Vulkan device at hand --------------------------------------------------
 */

typedef struct cost_device cost_device;

/* name: part of the device's name. NULL after one line in reason where it is not there. */
cost_device *cost_device_open(const char *name, const cost_points *points, char reason[256]);
void cost_device_close(cost_device *device);               /* NULL is fine */
const char *cost_device_name(const cost_device *device);   /* "llvmpipe (...)" */
const char *cost_device_driver(const cost_device *device); /* "llvmpipe Mesa 22.3.6 (...)" */

/* Time of a shader of eight evaluations an invocation over that of the same shader with an addition
 * in place of the evaluation: the fastest run of each, made in turn. False after one line on
 * standard error. */
/* Values of the subject's own text at n points, given as lambda and cos_theta by turns. */
bool cost_device_values(cost_device *device, const cost_subject *subject, size_t n,
                        const float *pairs, float *values);
bool cost_device_run(cost_device *device, const cost_subject *subject, int samples, double *ratio);

/* ---- All of it ---------------------------------------------------------------------------------
 */

typedef struct cost_row {
    const cost_subject *subject;
    double max_abs_f32,
        rmse_f32; /* of L on the grid of fit/score.h; A_h: of A_h over the exact A */
    cost_count counts[COST_FAMILIES];
    cost_count include; /* the first family, of the text in sg.glsl */
    cost_time f32, f64, batch_f32, batch_f64;
    double device_ratio;
} cost_row;

typedef struct cost_options {
    const char *device; /* NULL: no device measured */
    const char *only;   /* a method's id, or NULL */
    bool quick;         /* fewer samples */
    bool counts_only;   /* no times */
} cost_options;

typedef struct cost_table {
    cost_subjects subjects;
    cost_row *rows; /* one a subject */
    cost_options options;
    int samples;
    bool counted;             /* at least one family */
    char counter_driver[600]; /* or the reason why nothing was counted */
    char device_name[300], device_driver[600];
    double call_overhead; /* nanoseconds of calling an empty function through a pointer */
} cost_table;

/* cost_measure.c. False after one line. */
bool cost_measure(cost_table *table, const cost_options *options);
void cost_table_free(cost_table *table);

/* cost_write.c: cost.csv and cost.json; deterministic: the CSV with counts and errors alone. */
bool cost_write_csv(const cost_table *table, const char *path, bool deterministic);
bool cost_write_json(const cost_table *table, const char *path);

#endif
