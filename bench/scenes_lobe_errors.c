/* scenes_lobe_errors.c: a picture lit by lobes beside the exact one. */
#include <math.h>
#include <stdlib.h>

#include "base/buffer.h"
#include "base/order.h"
#include "base/progress.h"
#include "scenes_lobes.h"

/* Symmetric mean absolute percentage error of a pixel's luminance, 0 to 1. */
static double smape(const float *light, const float *truth)
{
    double a = 0.0, b = 0.0;
    for (int c = 0; c < 3; c++) {
        a += (double)light[c];
        b += (double)truth[c];
    }
    if (!isfinite(a))
        return 1.0;
    double sum = fabs(a) + fabs(b);
    return sum > 0.0 ? fabs(a - b) / sum : 0.0;
}

/* Sums of a row of pixels, then of all. */
typedef struct row_sums {
    double errors, truth, largest;
    size_t surfaces, black;
} row_sums;

typedef struct compare_job {
    size_t width;
    const float *light, *truth;
    float *errors;
    row_sums *rows;
} compare_job;

static void compare_row(void *context, size_t y)
{
    const compare_job *job = context;
    size_t width = job->width;
    row_sums sums = {0};
    for (size_t i = y * width; i < (y + 1) * width; i++) {
        const float *light = job->light + 4 * i, *truth = job->truth + 4 * i;
        job->errors[i] = truth[3] == 0.0f ? -1.0f : (float)smape(light, truth);
        if (truth[3] == 0.0f)
            continue;
        sums.surfaces++;
        sums.errors += (double)job->errors[i];
        sums.truth += (double)truth[1];
        sums.black += truth[1] > 0.0f && !(light[1] > 0.0f);
        double off = fabs((double)light[1] - (double)truth[1]);
        sums.largest = isnan(off) ? (double)INFINITY : fmax(sums.largest, off);
    }
    job->rows[y] = sums;
}

lobe_outcome lobe_compare(size_t width, size_t height, const float *light, const float *truth,
                          float *errors)
{
    size_t count = 0;
    row_sums all = {0}, *rows = base_allocate((height + 1) * sizeof *rows);
    compare_job job = {width, light, truth, errors, rows};
    base_parallel(height, compare_row, &job);
    for (size_t y = 0; y < height; y++) {
        all.surfaces += rows[y].surfaces;
        all.errors += rows[y].errors;
        all.truth += rows[y].truth;
        all.black += rows[y].black;
        all.largest = fmax(all.largest, rows[y].largest);
    }
    free(rows);
    lobe_outcome o = {.black = all.black, .largest = all.largest};
    if (all.surfaces == 0)
        return o;
    double *of_surfaces = base_allocate(all.surfaces * sizeof *of_surfaces);
    for (size_t i = 0; i < width * height; i++)
        if (errors[i] >= 0.0f)
            of_surfaces[count++] = (double)errors[i];
    o.smape = all.errors / (double)count;
    o.smape_p99 = base_select(of_surfaces, count, (size_t)(0.99 * (double)(count - 1)));
    o.largest /= all.truth / (double)count;
    free(of_surfaces);
    return o;
}
