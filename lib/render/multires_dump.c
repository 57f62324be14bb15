/* The picture of the fragments: each a square of its level's colour. */
#include <stdio.h>
#include <stdlib.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/png.h"
#include "multires.h"

/* The level that a pixel's value comes from; -1: it has no surface. */
static int level_of(const multires *m, const float *illumination, uint32_t x, uint32_t y)
{
    enum { FINAL = 1, PART = 3, DARK = 4 }; /* of fragments.glsl */
    static const size_t before[RENDER_LEVELS] = {0, 256, 320, 336, 340};
    bool part = false;
    for (int l = 0; l < RENDER_LEVELS; l++) {
        size_t row = (size_t)m->push[0].tiles[0] << (4 - l);
        size_t at = before[l] * m->tiles + (y >> l) * row + (x >> l);
        float w = illumination[4 * at + 3];
        int state = w < 0 ? PART : (int)w;
        if (state == FINAL || state == DARK)
            return l;
        part = part || (l == 0 && state == PART);
    }
    return part ? 1 : -1; /* four pixels that are kept as parts of a fragment of level 1 */
}

bool multires_dump(const render_frame *frame, const multires *m, const char *folder)
{
    static const uint8_t colours[RENDER_LEVELS][3] = {
        {235, 70, 60}, {240, 150, 50}, {240, 220, 80}, {90, 180, 90}, {70, 120, 210}};
    size_t width = frame->width, height = frame->height;
    const float *illumination = gpu_buffer_map(m->illumination);
    uint8_t *rgb = base_allocate(3 * width * height);
    for (uint32_t y = 0; y < height; y++)
        for (uint32_t x = 0; x < width; x++) {
            int l = level_of(m, illumination, x, y);
            uint32_t mask = l > 0 ? (1u << l) - 1 : 0;
            bool border = l > 1 && ((x & mask) == 0 || (y & mask) == 0);
            for (size_t k = 0; k < 3; k++) {
                int value = l < 0 ? 0 : border ? colours[l][k] / 2 : colours[l][k];
                rgb[3 * (y * width + x) + k] = (uint8_t)value;
            }
        }
    char *path = base_join(folder, "fragments.png");
    bool good = png_write(path, (int)width, (int)height, rgb);
    free(path);
    free(rgb);
    return good;
}
