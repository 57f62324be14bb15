/* png.h: pictures for people. */
#ifndef BASE_PNG_H
#define BASE_PNG_H

#include <stdbool.h>
#include <stdint.h>

/* Writes an 8-bit RGB picture: 3 bytes a pixel, rows from the top. The file appears whole or not
 * at all. False after one line. */
bool png_write(const char *path, int width, int height, const uint8_t *rgb);

/* The same from linear values: each channel times exposure, clamped to [0, 1] (NaN: 0) and encoded
 * as sRGB. stride: floats from one pixel to the next, at least 3. */
bool png_write_linear(const char *path, int width, int height, const float *pixels, int stride,
                      float exposure);

#endif
