/* Indirect light beside its reference. */
#include "bounce.h"

#include <math.h>

void bounce_compare(const bounce *reference, const float *light, uint32_t width, uint32_t step,
                    bounce_comparison *result)
{
    double squares = 0, noise = 0, bias = 0, mean = 0, count = 0;
    for (uint32_t y = 0; y < reference->height; y++)
        for (uint32_t x = 0; x < reference->width; x++) {
            size_t at = (size_t)y * reference->width + x;
            size_t pixel = (size_t)(y * step + step / 2) * width + x * step + step / 2;
            for (size_t k = 0; k < 3 && reference->irradiance[4 * at + 3] != 0; k++) {
                double truth = (double)reference->irradiance[4 * at + k];
                double off = (double)light[4 * pixel + k] - truth;
                squares += off * off;
                noise += (double)reference->variance[3 * at + k];
                bias += off;
                mean += truth;
                count++;
            }
        }
    *result = (bounce_comparison){0};
    if (!(mean > 0))
        return;
    mean /= count;
    result->rel = sqrt(squares / count) / mean;
    result->noise = sqrt(noise / count) / mean;
    result->bias = bias / count / mean;
    result->mean = mean;
}
