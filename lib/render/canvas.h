/* canvas.h: small pictures of a pipeline's stages: pixels, lines, false colours. */
#ifndef RENDER_CANVAS_H
#define RENDER_CANVAS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct canvas {
    int width, height;
    uint8_t *rgb; /* NULL: there was no memory; drawing does nothing then */
} canvas;

typedef struct canvas_color {
    uint8_t r, g, b;
} canvas_color;

canvas canvas_open(int width, int height); /* black */
void canvas_close(canvas *c);

/* "folder/name", as PNG. False after one line. */
bool canvas_write(const canvas *c, const char *folder, const char *name);

/* Outside: nothing happens. */
void canvas_set(canvas *c, int x, int y, canvas_color color);
void canvas_line(canvas *c, int x0, int y0, int x1, int y1, canvas_color color);
void canvas_outline(canvas *c, int x0, int y0, int x1, int y1, canvas_color color); /* inclusive */

/* Well distinguishable colours for numbers that have no order. */
canvas_color canvas_number(uint32_t number);

/* 0 to 1: dark violet over green to yellow; beyond: the ends; NaN: white. */
canvas_color canvas_scale(double value);

/* Grey from the depth of a depth image: nearest light, farthest dark, by the logarithm of the
 * distance; black where it is 1. count values, to the canvas's first count pixels. */
void canvas_depth(canvas *c, const float *depth, size_t count);

#endif
