/* scenes_picture.c: errors in false colours. */
#include <math.h>
#include <stdlib.h>

#include "base/buffer.h"
#include "base/png.h"
#include "scenes.h"

static uint8_t byte(double value)
{
    return (uint8_t)lrint(255.0 * fmin(fmax(value, 0.0), 1.0));
}

bool scenes_write_errors(const char *path, uint32_t width, uint32_t height, const float *errors,
                         const float *truth)
{
    size_t pixels = (size_t)width * height;
    uint8_t *rgb = base_allocate(3 * pixels + 1);
    for (size_t i = 0; i < pixels; i++) {
        bool surface = truth[4 * i + 3] != 0.0f;
        double error = 4.0 * (double)errors[i];
        rgb[3 * i] = surface ? byte(2.0 * error) : 0;
        rgb[3 * i + 1] = surface ? byte(2.0 - 2.0 * error) : 0;
        rgb[3 * i + 2] = 0;
    }
    bool good = png_write(path, (int)width, (int)height, rgb);
    free(rgb);
    return good;
}
