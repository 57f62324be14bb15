/* How far an image of irradiance is from the truth. */
#include "render.h"

#include <math.h>
#include <stdlib.h>

#include "base/buffer.h"
#include "base/order.h"

static bool compared(const float *light, const float *truth)
{
    return truth[3] != 0 && light[3] != -1;
}

/* The least error that is not below that share of them. Asked from the greatest share down, each
 * time of the errors up to the one found before: count is left at that. */
static double percentile(double *errors, size_t all, size_t *count, double share)
{
    size_t rank = (size_t)ceil(share * (double)all);
    if (*count == 0)
        return 0;
    rank = rank > 0 ? rank - 1 : 0;
    double found = base_select(errors, *count, rank);
    *count = rank + 1;
    return found;
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
    double *kept = base_allocate((count ? count : 1) * sizeof *kept);
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
        kept[at++] = (double)(float)error;
        squares += error * error;
    }
    *result = (render_comparison){
        .rel = count ? sqrt(squares / (double)count) : 0,
        .bias = difference != 0 ? difference / sum : 0,
    };
    result->p999 = percentile(kept, count, &at, 0.999);
    result->p99 = percentile(kept, count, &at, 0.99);
    result->p95 = percentile(kept, count, &at, 0.95);
    result->p50 = percentile(kept, count, &at, 0.5);
    free(kept);
}
