/* mesh_jpeg.h: JPEG textures. */
#ifndef RENDER_MESH_JPEG_H
#define RENDER_MESH_JPEG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Texels of 4 bytes, red, green, blue and 255, whatever the file's colours are; free() them. False
 * where the file is damaged, cut off, or a side longer than longest; nothing is printed. */
bool mesh_jpeg(const uint8_t *bytes, size_t size, unsigned longest, uint8_t **texels,
               size_t *count);

#endif
