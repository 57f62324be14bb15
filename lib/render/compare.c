/* How far an image of irradiance is from the truth. */
#include "render.h"

#include <math.h>
#include <stdlib.h>

#include "base/buffer.h"

static int ascending(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

static bool compared(const float *light, const float *truth)
{
    return truth[3] != 0 && light[3] != -1;
}

/* The least error that is not below that share of them. */
static double percentile(const float *sorted, size_t count, double share)
{
    size_t rank = (size_t)ceil(share * (double)count);
    return count ? (double)sorted[rank > 0 ? rank - 1 : 0] : 0;
}

void render_compare(size_t pixels, const float *light, const float *truth, float *errors,
                    render_comparison *result)
{
    double sum = 0, difference = 0, squares = 0;
    size_t count = 0;
    for (size_t i = 0; i < 4 * pixels; i += 4)
        if (compared(light + i, truth + i)) {
            for (int c = 0; c < 3; c++) {
                sum += (double)truth[i + (size_t)c];
                difference += (double)light[i + (size_t)c] - (double)truth[i + (size_t)c];
            }
            count++;
        }
    double mean = count ? sum / (3 * (double)count) : 0;
    float *sorted = base_allocate((count ? count : 1) * sizeof *sorted);
    size_t at = 0;
    for (size_t i = 0; i < pixels; i++) {
        const float *e = light + 4 * i, *t = truth + 4 * i;
        double square = 0;
        for (int c = 0; c < 3; c++)
            square += ((double)e[c] - (double)t[c]) * ((double)e[c] - (double)t[c]) / 3;
        /* next to a black truth any light at all is infinitely wrong, and none is right */
        double error = square > 0 ? sqrt(square) / mean : 0;
        bool counts = compared(e, t);
        if (errors)
            errors[i] = counts ? (float)error : 0;
        if (!counts)
            continue;
        sorted[at++] = (float)error;
        squares += error * error;
    }
    qsort(sorted, count, sizeof *sorted, ascending);
    *result = (render_comparison){
        .rel = count ? sqrt(squares / (double)count) : 0,
        .p50 = percentile(sorted, count, 0.5),
        .p95 = percentile(sorted, count, 0.95),
        .p99 = percentile(sorted, count, 0.99),
        .p999 = percentile(sorted, count, 0.999),
        .bias = difference != 0 ? difference / sum : 0,
    };
    free(sorted);
}
