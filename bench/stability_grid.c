/* stability_grid.c: the points of the scan, and the truth there. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/progress.h"
#include "base/text.h"
#include "fit/score.h"
#include "stability_private.h"

static const double pi = 3.14159265358979323846;

void *stability_allocate(size_t size)
{
    void *memory = malloc(size ? size : 1);
    if (!memory) {
        base_error("out of memory");
        abort();
    }
    return memory;
}

const char *stability_precision_name(stability_precision precision)
{
    static const char *const names[STABILITY_PRECISIONS] = {"f64", "f32", "f16", "device"};
    return names[precision];
}

double stability_rounded(stability_precision precision, double value)
{
    static const score_precision of[STABILITY_PRECISIONS] = {SCORE_F64, SCORE_F32, SCORE_F16,
                                                             SCORE_F32};
    if (isnan(value) || isinf(value))
        return value;
    if (of[precision] == SCORE_F32 && fabs(value) > (double)FLT_MAX * (1.0 + 0x1p-25))
        return copysign((double)INFINITY, value); /* the conversion would be undefined */
    return score_rounded(of[precision], value);
}

/* ---- The lists --------------------------------------------------------------------------------
 */

typedef struct list {
    double *values;
    size_t count, capacity;
} list;

static void add(list *list, stability_precision precision, double value)
{
    if (list->count == list->capacity) {
        list->capacity = list->capacity ? 2 * list->capacity : 1024;
        list->values = realloc(list->values, list->capacity * sizeof *list->values);
        if (!list->values)
            abort();
    }
    list->values[list->count++] = stability_rounded(precision, value);
}

static int increasing(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Sorted, each number once; 0 and -0 are one. */
static void tidy(list *list)
{
    qsort(list->values, list->count, sizeof *list->values, increasing);
    size_t kept = 0;
    for (size_t i = 0; i < list->count; i++)
        if (kept == 0 || list->values[i] != list->values[kept - 1])
            list->values[kept++] = list->values[i] + 0.0;
    list->count = kept;
}

/* Dense where anything can happen, less so outside; the ends of the number formats. */
static list lambdas(stability_precision precision, bool quick)
{
    static const double ends[] = {0,
                                  DBL_TRUE_MIN,
                                  1e-310,
                                  DBL_MIN,
                                  1e-300,
                                  1e-200,
                                  1e-100,
                                  1e-50,
                                  (double)FLT_TRUE_MIN,
                                  1e-44,
                                  1e-42,
                                  1e-40,
                                  (double)FLT_MIN / 2,
                                  (double)FLT_MIN,
                                  1e-37,
                                  1e-35,
                                  0x1p-24,
                                  0x1p-23,
                                  0x1p-14,
                                  1e31,
                                  1e33,
                                  1e35,
                                  1e36,
                                  5e36,
                                  1e37,
                                  2e37,
                                  8e37,
                                  1.8e38,
                                  (double)FLT_MAX,
                                  1e50,
                                  1e100,
                                  1e154,
                                  1e200,
                                  1e300,
                                  DBL_MAX,
                                  65504,
                                  (double)INFINITY};
    int fine = quick ? 16 : 64, coarse = quick ? 4 : 16;
    list found = {0};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        add(&found, precision, ends[i]);
    for (int i = -12 * fine; i <= 12 * fine; i++)
        add(&found, precision, pow(10, (double)i / fine));
    for (int i = 12 * coarse; i <= 30 * coarse; i++) {
        add(&found, precision, pow(10, (double)i / coarse));
        add(&found, precision, pow(10, -(double)i / coarse));
    }
    tidy(&found);
    return found;
}

/* Uniform in beta; logarithmic about the terminator and about both poles; slightly outside. */
static list cosines(stability_precision precision, bool quick)
{
    static const double special[] = {1e-300, 1e-45, 1e-40, 1e-38, 1e-30,    1e-20,
                                     1e-16,  1e-14, 1e-12, 1e-10, 1 + 1e-7, 1 + 1e-6};
    int angles = quick ? 48 : 144, logs = quick ? 3 : 9;
    list found = {0};
    for (int i = 0; i <= angles; i++)
        add(&found, precision, cos(pi * i / angles));
    add(&found, precision, 0);
    for (int sign = -1; sign <= 1; sign += 2) {
        if (precision == STABILITY_F16)
            add(&found, precision, sign * (1 + 0x1p-10));
        for (size_t i = 0; i < sizeof special / sizeof *special; i++)
            add(&found, precision, sign * special[i]);
        for (int i = 1; i <= 4 * logs; i++)
            add(&found, precision, sign * pow(10, -(double)i / logs));
        for (int i = 9; i <= 18; i++) {
            add(&found, precision, sign * pow(10, -i / 2.0));
            add(&found, precision, sign * (1 - pow(10, -i / 2.0)));
        }
        add(&found, precision, sign * (1 - 1e-2));
        add(&found, precision, sign * (1 - 1e-3));
        add(&found, precision, sign * (1 - 0x1p-24));
        add(&found, precision, sign * (1 - 0x1p-11));
    }
    tidy(&found);
    return found;
}

static void truth_row(void *context, size_t index)
{
    stability_grid *grid = context;
    double *lambda = stability_allocate(grid->cosines * sizeof *lambda);
    for (size_t j = 0; j < grid->cosines; j++)
        lambda[j] = grid->lambda[index];
    sg_L_cos_batch(grid->cosines, lambda, grid->cos_theta, grid->truth + index * grid->cosines);
    free(lambda);
}

stability_grid *stability_grid_new(stability_precision precision, bool quick)
{
    stability_grid *grid = stability_allocate(sizeof *grid);
    list rows = lambdas(precision, quick), columns = cosines(precision, quick);
    *grid = (stability_grid){.precision = precision,
                             .lambda = rows.values,
                             .cos_theta = columns.values,
                             .lambdas = rows.count,
                             .cosines = columns.count};
    grid->truth = stability_allocate(grid->lambdas * grid->cosines * sizeof *grid->truth);
    base_parallel(grid->lambdas, truth_row, grid);
    return grid;
}

void stability_grid_free(stability_grid *grid)
{
    if (!grid)
        return;
    free(grid->lambda);
    free(grid->cos_theta);
    free(grid->truth);
    free(grid);
}
