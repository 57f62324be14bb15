#include "canvas.h"

#include <math.h>
#include <stdlib.h>

#include "base/file.h"
#include "base/png.h"

canvas canvas_open(int width, int height)
{
    return (canvas){width, height, calloc((size_t)width * (size_t)height, 3)};
}

void canvas_close(canvas *c)
{
    free(c->rgb);
    *c = (canvas){0, 0, NULL};
}

bool canvas_write(const canvas *c, const char *folder, const char *name)
{
    char *path = base_join(folder, name);
    bool done = path && c->rgb && png_write(path, c->width, c->height, c->rgb);
    free(path);
    return done;
}

void canvas_set(canvas *c, int x, int y, canvas_color color)
{
    if (!c->rgb || x < 0 || y < 0 || x >= c->width || y >= c->height)
        return;
    uint8_t *at = c->rgb + 3 * ((size_t)y * (size_t)c->width + (size_t)x);
    at[0] = color.r;
    at[1] = color.g;
    at[2] = color.b;
}

void canvas_line(canvas *c, int x0, int y0, int x1, int y1, canvas_color color)
{
    int dx = abs(x1 - x0), dy = abs(y1 - y0), steps = dx > dy ? dx : dy;
    for (int i = 0; i <= steps; i++) {
        double t = steps ? (double)i / steps : 0;
        canvas_set(c, x0 + (int)lround(t * (x1 - x0)), y0 + (int)lround(t * (y1 - y0)), color);
    }
}

void canvas_outline(canvas *c, int x0, int y0, int x1, int y1, canvas_color color)
{
    canvas_line(c, x0, y0, x1, y0, color);
    canvas_line(c, x1, y0, x1, y1, color);
    canvas_line(c, x1, y1, x0, y1, color);
    canvas_line(c, x0, y1, x0, y0, color);
}

canvas_color canvas_number(uint32_t number)
{
    uint32_t bits = number * 2654435761U;
    bits ^= bits >> 15;
    bits *= 2246822519U;
    bits ^= bits >> 13;
    return (canvas_color){(uint8_t)(64 + (bits & 0xff) * 191 / 255),
                          (uint8_t)(64 + (bits >> 8 & 0xff) * 191 / 255),
                          (uint8_t)(64 + (bits >> 16 & 0xff) * 191 / 255)};
}

canvas_color canvas_scale(double value)
{
    static const double stops[5][3] = {
        {40, 10, 70}, {45, 75, 140}, {30, 145, 140}, {95, 200, 95}, {250, 230, 40}};
    if (!(value == value))
        return (canvas_color){255, 255, 255};
    double at = 4 * (value < 0 ? 0 : value > 1 ? 1 : value);
    int i = at >= 4 ? 3 : (int)at;
    uint8_t out[3];
    for (int k = 0; k < 3; k++)
        out[k] = (uint8_t)lround(stops[i][k] + (at - i) * (stops[i + 1][k] - stops[i][k]));
    return (canvas_color){out[0], out[1], out[2]};
}

void canvas_depth(canvas *c, const float *depth, size_t count)
{
    /* 1 - depth falls nearly as 1/distance */
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < count; i++)
        if (depth[i] < 1) {
            double far = -log(1 - (double)depth[i]);
            low = far < low ? far : low;
            high = far > high ? far : high;
        }
    for (size_t i = 0; i < count && c->rgb; i++) {
        double far = depth[i] < 1 ? -log(1 - (double)depth[i]) : high;
        double near = high > low ? (high - far) / (high - low) : 1;
        uint8_t grey = depth[i] < 1 ? (uint8_t)lround(40 + 150 * near) : 0;
        for (int k = 0; k < 3; k++)
            c->rgb[3 * i + (size_t)k] = grey;
    }
}
