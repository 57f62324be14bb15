/* Pictures for people: tone-mapped radiance, layers, errors in false colours. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/png.h"
#include "output.h"

bool output_png(const char *path, int width, int height, const float *radiance, double gain)
{
    size_t pixels = (size_t)width * (size_t)height;
    float *toned = base_allocate(pixels * 3 * sizeof *toned);
    for (size_t i = 0; i < pixels; i++)
        for (size_t c = 0; c < 3; c++)
            toned[3 * i + c] = render_tone(gain, radiance[4 * i + c]);
    bool good = png_write_linear(path, width, height, toned, 3, 1);
    free(toned);
    return good;
}

bool output_false_colour(const char *path, int width, int height, const float *values, float scale)
{
    enum { STOPS = 5 };
    static const float stops[STOPS][3] = {
        {0, 0, 0}, {90, 20, 120}, {220, 50, 40}, {250, 200, 40}, {255, 255, 255}};
    size_t pixels = (size_t)width * (size_t)height;
    uint8_t *rgb = base_allocate(pixels * 3);
    for (size_t i = 0; i < pixels; i++) {
        float x = values[i] * scale;
        x = x > 0 ? x < 1 ? x : 1 : 0;
        float place = x * (STOPS - 1);
        int stop = place < STOPS - 2 ? (int)place : STOPS - 2;
        float part = place - (float)stop;
        for (int c = 0; c < 3; c++)
            rgb[3 * i + (size_t)c] =
                (uint8_t)lroundf(stops[stop][c] + part * (stops[stop + 1][c] - stops[stop][c]));
    }
    bool good = png_write(path, width, height, rgb);
    free(rgb);
    return good;
}

static bool picture(const char *folder, const char *name, const output_frame *out,
                    const float *pixels, int stride)
{
    char *path = base_join(folder, name);
    bool good = path && png_write_linear(path, out->width, out->height, pixels, stride, 1);
    free(path);
    return good;
}

/* -1 to 1 becomes 0 to 1. */
static bool normals(const char *folder, const char *name, const output_frame *out,
                    const float *normals)
{
    size_t count = 3 * (size_t)out->width * (size_t)out->height;
    float *colours = base_allocate(count * sizeof *colours);
    for (size_t i = 0; i < count; i++)
        colours[i] = 0.5F + 0.5F * normals[i];
    bool good = picture(folder, name, out, colours, 3);
    free(colours);
    return good;
}

/* Distance as nearest over distance: white is nearest. */
static bool depth(const char *folder, const output_frame *out)
{
    size_t pixels = (size_t)out->width * (size_t)out->height;
    float *grey = base_allocate(pixels * 3 * sizeof *grey), nearest = INFINITY;
    for (size_t i = 0; i < pixels; i++)
        if (out->position[4 * i + 3] > 0 && out->position[4 * i + 3] < nearest)
            nearest = out->position[4 * i + 3];
    for (size_t i = 0; i < 3 * pixels; i++) {
        float z = out->position[i / 3 * 4 + 3];
        grey[i] = z > 0 ? nearest / z : 0;
    }
    bool good = picture(folder, "depth.png", out, grey, 3);
    free(grey);
    return good;
}

/* Uncovered pixels red, wrongly owned ones blue, on a dark picture of what is lit. */
static bool coverage(const char *folder, const output_frame *out, double gain)
{
    size_t pixels = (size_t)out->width * (size_t)out->height;
    float *colours = base_allocate(pixels * 3 * sizeof *colours);
    for (size_t i = 0; i < pixels; i++) {
        float state = out->light[4 * i + 3];
        float grey = 0.3F * render_tone(gain, out->radiance[4 * i + 1]);
        colours[3 * i] = state == -1 ? 1 : grey;
        colours[3 * i + 1] = state < 0 ? 0 : grey;
        colours[3 * i + 2] = state == -2 ? 1 : grey;
    }
    bool good = picture(folder, "coverage.png", out, colours, 3);
    free(colours);
    return good;
}

/* Irradiance and the truth with the same exposure: a white surface under the light. */
static bool light(const char *folder, const char *name, const output_frame *out,
                  const float *pixels, double gain)
{
    char *path = base_join(folder, name);
    bool good =
        path && output_png(path, out->width, out->height, pixels, gain / 3.14159265358979323846);
    free(path);
    return good;
}

bool output_dump(const char *folder, const output_frame *out, double gain)
{
    bool good = depth(folder, out) && normals(folder, "normal.png", out, out->shading) &&
                normals(folder, "geometric_normal.png", out, out->geometric) &&
                picture(folder, "albedo.png", out, out->albedo, 4) &&
                light(folder, "irradiance.png", out, out->light, gain) &&
                coverage(folder, out, gain);
    if (!good || !out->truth)
        return good;
    char *path = base_join(folder, "error_times_4.png");
    good = path && light(folder, "truth.png", out, out->truth, gain) &&
           output_false_colour(path, out->width, out->height, out->errors, 4);
    free(path);
    return good;
}
