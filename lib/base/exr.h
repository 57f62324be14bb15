/* exr.h: OpenEXR images to and from arrays of float. */
#ifndef BASE_EXR_H
#define BASE_EXR_H

#include <stdbool.h>
#include <stddef.h>

#include "buffer.h"

typedef struct exr_text {
    const char *name, *value;
} exr_text;

typedef struct exr_channel {
    const char *name;    /* "Y", or with a layer: "position.X" */
    const float *pixels; /* width*height, rows from y = 0 on */
    int stride;          /* floats from one pixel to the next; 0 counts as 1 */
    bool half;           /* as half, else as float */
} exr_channel;

typedef struct exr_image {
    int width, height;
    const exr_channel *channels; /* of different names */
    size_t channel_count;
    bool half;       /* every channel as half */
    bool compressed; /* without loss (zips) */
    const exr_text *attributes;
    size_t attribute_count;
} exr_image;

/* The bytes of an EXR file. False after one line. */
bool exr_encode(buffer *out, const exr_image *image);

/* The same into a file, which appears whole or not at all. */
bool exr_write(const char *path, const exr_image *image);

/* Reads one channel of a file whatever its compression; NULL: the only one. width*height pixels,
 * free() them. NULL after one line. */
float *exr_read(const char *path, const char *channel, int *width, int *height);

#endif
