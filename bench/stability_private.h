/* stability_private.h: what the files of the stability scan share. */
#ifndef BENCH_STABILITY_PRIVATE_H
#define BENCH_STABILITY_PRIVATE_H

#include "stability.h"

struct stability_grid {
    stability_precision precision;
    double *lambda, *cos_theta; /* increasing; as the precision holds them; no number twice */
    size_t lambdas, cosines;
    double *truth; /* the reference L, cosines of each lambda after each other */
};

/* malloc that ends the program. */
void *stability_allocate(size_t size);

void stability_add(stability_table *table, const stability_row *row);

/* The values of a subject at a list of points; arrays that the subject has no function for are
 * NULL. */
typedef struct stability_values {
    double *value, *truth, *twin, *flushed, *A_h;
} stability_values;

bool stability_evaluate(const stability_subject *subject, size_t n, const double *lambda,
                        const double *cos_theta, const double *known_truth,
                        stability_values *values);
void stability_values_free(stability_values *values);

/* stability_kinds.c: what counts as a failure. */
enum { STABILITY_KINDS = 14 };
const char *stability_kind_name(int kind);
/* How bad point i is in that kind, above 0, or 0 where it is no failure or the kind does not apply
 * to the subject. worst: the number to show. */
double stability_severity(int kind, const stability_subject *subject,
                          const stability_values *values, size_t i, double *worst);

/* stability_points.c: add rows; false after one line. */
bool stability_scan_limit(const stability_subject *subject, const stability_grid *grid,
                          stability_table *table);
bool stability_scan_nan(const stability_subject *subject, stability_table *table);

/* stability_seams.c: both sides of a seam at that place, as rows. */
void stability_seam_add(stability_seams *seams, stability_precision precision, double lambda,
                        double cos_theta);

/* stability_long.c: L of a method of the registry in long double; NULL where that is no wider than
 * double, or there is no such method. */
double (*stability_long_L(const char *id))(double lambda, double cos_theta);

/* stability_operations.c: adds the rows of the lobe operations (stability_cores.h). */
bool stability_operations(stability_table *table);

/* stability_command.c: the tables as files. */
bool stability_write(const stability_options *options, const stability_result *result);

/* stability_device.c */
typedef struct stability_device stability_device;
/* NULL after one line in reason. */
stability_device *stability_device_open(const char *name, char reason[256]);
void stability_device_close(stability_device *device); /* NULL is fine */
const char *stability_device_name(const stability_device *device);
/* The method's functions in shaders/sg.glsl; close it with stability_device_forget before the next.
 * False after one line. */
bool stability_device_subject(stability_device *device, const sg_method *method,
                              stability_subject *subject);
void stability_device_forget(stability_device *device);

#endif
