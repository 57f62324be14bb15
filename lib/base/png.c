#include "png.h"

#include <math.h>
#include <png.h>
#include <stdlib.h>

#include "buffer.h"
#include "file.h"
#include "text.h"

bool png_write(const char *path, int width, int height, const uint8_t *rgb)
{
    if (width < 1 || height < 1) {
        base_error("%s: a picture needs at least 1 x 1 pixels, not %d x %d", path, width, height);
        return false;
    }
    png_image image = {.version = PNG_IMAGE_VERSION,
                       .width = (png_uint_32)width,
                       .height = (png_uint_32)height,
                       .format = PNG_FORMAT_RGB};
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    uint8_t *bytes = base_allocate(size);
    bool good = png_image_write_to_memory(&image, bytes, &size, 0, rgb, 0, NULL) != 0;
    if (good)
        good = base_write_file(path, bytes, size);
    else
        base_error("%s: cannot encode PNG: %s", path, image.message);
    free(bytes);
    return good;
}

static uint8_t encode(float linear)
{
    double x = linear > 0 ? fmin((double)linear, 1) : 0; /* NaN compares false */
    x = x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;
    return (uint8_t)lround(255 * x);
}

bool png_write_linear(const char *path, int width, int height, const float *pixels, int stride,
                      float exposure)
{
    size_t count = width > 0 && height > 0 ? (size_t)width * (size_t)height : 0;
    uint8_t *rgb = base_allocate(3 * count);
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < 3; c++)
            rgb[3 * i + c] = encode(exposure * pixels[i * (size_t)stride + c]);
    bool good = png_write(path, width, height, rgb);
    free(rgb);
    return good;
}
