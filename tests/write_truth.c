/* Writes ground truth of a scene to EXR, made by the CPU alone:
 *     write_truth SCENE.json WIDTH HEIGHT OUT.exr
 * Channels R, G, B: irradiance; Z: depth along the view axis, 0 where there is no surface. */
#include <stdio.h>
#include <stdlib.h>

#include "base/exr.h"
#include "base/text.h"
#include "reference_render.h"

int main(int argc, char **argv)
{
    long width = 0, height = 0;
    if (argc != 5 || !base_parse_long(argv[2], &width) || !base_parse_long(argv[3], &height) ||
        width < 1 || height < 1 || width > 4096 || height > 4096) {
        base_error("expected write_truth SCENE.json WIDTH HEIGHT OUT.exr");
        return 2;
    }
    render_scene scene;
    if (!render_scene_read(argv[1], NULL, &scene))
        return 2;
    size_t pixels = (size_t)width * (size_t)height, lights = 0;
    reference *from = reference_open(&scene);
    reference_pixel *view = calloc(pixels, sizeof *view);
    double(*rgb)[3] = calloc(pixels, sizeof *rgb);
    float *planes = calloc(4 * pixels, sizeof *planes);
    reference_light *list = from ? reference_lights(from, &lights) : NULL;
    bool good = from && view && rgb && planes && list;
    if (good) {
        reference_view(from, &scene.camera, (int)width, (int)height, view);
        reference_irradiance(view, pixels, list, lights, rgb);
        for (size_t i = 0; i < pixels; i++) {
            for (size_t c = 0; c < 3; c++)
                planes[c * pixels + i] = (float)rgb[i][c];
            planes[3 * pixels + i] = (float)view[i].depth;
        }
        const exr_channel channels[] = {{.name = "R", .pixels = planes},
                                        {.name = "G", .pixels = planes + pixels},
                                        {.name = "B", .pixels = planes + 2 * pixels},
                                        {.name = "Z", .pixels = planes + 3 * pixels}};
        const exr_text text[] = {
            {"content", "R, G, B: irradiance (W/m^2); Z: depth, 0 without a surface"},
            {"source", "tests/write_truth.c: rays by Embree, form factors in double"}};
        const exr_image image = {.width = (int)width,
                                 .height = (int)height,
                                 .channels = channels,
                                 .channel_count = 4,
                                 .compressed = true,
                                 .attributes = text,
                                 .attribute_count = 2};
        good = exr_write(argv[4], &image);
    }
    reference_close(from);
    render_scene_free(&scene);
    free(view);
    free(rgb);
    free(planes);
    free(list);
    return good ? 0 : 1;
}
