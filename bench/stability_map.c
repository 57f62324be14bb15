/* stability_map.c: the failure maps, as EXR to be read by programs and as PNG to be looked at. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/exr.h"
#include "base/png.h"
#include "stability_private.h"

enum { WIDTH = STABILITY_MAP_WIDTH, HEIGHT = STABILITY_MAP_HEIGHT, PIXELS = WIDTH * HEIGHT };

const double stability_map_lambda_min = 1e-12, stability_map_lambda_max = 1e12;

static const double pi = 3.14159265358979323846;
static const double least_error = 1e-17;

static stability_mark mark_of(stability_precision precision, double value)
{
    double slack = precision == STABILITY_F16 ? 0x1p-10 : 1e-6;
    return isnan(value)        ? STABILITY_NAN
           : isinf(value)      ? STABILITY_INFINITE
           : value < -1e-6     ? STABILITY_NEGATIVE
           : value > 1 + slack ? STABILITY_ABOVE_ONE
                               : STABILITY_FINE;
}

bool stability_map_make(const stability_subject *subject, stability_map *map)
{
    double *lambda = stability_allocate(4 * PIXELS * sizeof *lambda), *cos_theta = lambda + PIXELS,
           *value = cos_theta + PIXELS, *truth = value + PIXELS;
    double decades = log10(stability_map_lambda_max / stability_map_lambda_min);
    for (int i = 0; i < PIXELS; i++) {
        double x = (i % WIDTH) / (WIDTH - 1.0), y = (i / WIDTH) / (HEIGHT - 1.0);
        lambda[i] =
            stability_rounded(subject->precision, stability_map_lambda_min * pow(10, decades * x));
        cos_theta[i] = stability_rounded(subject->precision, cos(pi * y));
    }
    bool good = subject->value(subject, PIXELS, lambda, cos_theta, value);
    sg_L_cos_batch(PIXELS, lambda, cos_theta, truth);
    for (int i = 0; good && i < PIXELS; i++) {
        map->mark[i] = (float)mark_of(subject->precision, value[i]);
        map->error[i] =
            isnan(value[i]) ? NAN : (float)log10(fmax(fabs(value[i] - truth[i]), least_error));
    }
    free(lambda);
    return good;
}

/* From dark blue through green to yellow, in even steps of lightness. */
void stability_color(double log10_error, stability_mark mark, uint8_t rgb[3])
{
    static const double scale[][3] = {
        {68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
    static const uint8_t marks[STABILITY_MARKS][3] = {
        {0, 0, 0}, {86, 180, 233}, {255, 127, 14}, {0, 0, 0}, {214, 39, 40}};
    if (mark != STABILITY_FINE) {
        memcpy(rgb, marks[mark], 3);
        return;
    }
    double at = fmin(fmax((log10_error + 8) / 8, 0), 1) * 4;
    int below = at < 3 ? (int)at : 3;
    for (int c = 0; c < 3; c++)
        rgb[c] = (uint8_t)lround(scale[below][c] +
                                 (at - below) * (scale[below + 1][c] - scale[below][c]));
}

static bool write_png(const stability_map *map, const char *path)
{
    uint8_t pixels[PIXELS][3];
    for (int i = 0; i < PIXELS; i++)
        stability_color((double)map->error[i], (stability_mark)map->mark[i], pixels[i]);
    return png_write(path, WIDTH, HEIGHT, &pixels[0][0]);
}

static bool write_exr(const stability_map *map, const char *path)
{
    static const exr_text attributes[] = {
        {"content",
         "Y: log10 of the absolute error of L, at least -17; mark: 0 a number in [0, 1], "
         "1 negative, 2 above one, 3 infinite, 4 NaN"},
        {"mapping", "x: sharpness, logarithmic from 1e-12 to 1e12; y: beta, uniform from 0 to pi"}};
    const exr_channel channels[] = {{.name = "Y", .pixels = map->error},
                                    {.name = "mark", .pixels = map->mark}};
    const exr_image image = {WIDTH, HEIGHT, channels, 2, true, true, attributes, 2};
    return exr_write(path, &image);
}

bool stability_map_write(const stability_map *map, const char *path)
{
    size_t size = strlen(path) + 5;
    char *name = stability_allocate(size);
    memcpy(name, path, size - 5);
    memcpy(name + size - 5, ".exr", 5);
    bool good = write_exr(map, name);
    memcpy(name + size - 5, ".png", 5);
    good = good && write_png(map, name);
    free(name);
    return good;
}
