/* exr.h: one-channel OpenEXR images, uncompressed, to and from memory-sized arrays of float. */
#ifndef TABLES_EXR_H
#define TABLES_EXR_H

#include <stdbool.h>

#include "buffer.h"

typedef struct exr_text {
    const char *name, *value;
} exr_text;

/* The bytes of an EXR file of one channel named Y, as half where `half`, else as float; rows from
 * y = 0 on; attributes are strings. False after one line. */
bool exr_encode(buffer *out, const float *pixels, int width, int height, bool half,
                const exr_text *attributes, size_t attribute_count);

/* Reads such a file whatever its compression; width*height pixels, free() them. NULL after one
 * line. */
float *exr_read(const char *path, int *width, int *height);

#endif
