/* A fixed stratified set of points on a flat polygon. */
#include <math.h>

#include "shadows.h"

void shadows_normal(const render_area_light *light, double normal[3])
{
    const double *a = light->corners[0];
    normal[0] = normal[1] = normal[2] = 0;
    for (int i = 1; i + 1 < light->corner_count; i++) {
        const double *b = light->corners[i], *c = light->corners[i + 1];
        double e[3], f[3];
        for (int k = 0; k < 3; k++)
            e[k] = b[k] - a[k], f[k] = c[k] - a[k];
        for (int k = 0; k < 3; k++)
            normal[k] += 0.5 * (e[(k + 1) % 3] * f[(k + 2) % 3] - e[(k + 2) % 3] * f[(k + 1) % 3]);
    }
}

/* Place i of the set in the unit square. On a grid of 8 x 8 cells each point is moved within its
 * cell so that no two share a row or a column of 64 (the canonical arrangement of multi-jittered
 * sampling): the shadow of a straight edge along the light comes in 64 steps, not in 8. Points
 * are ordered so that each 16 take one cell of each 2 x 2, another one from block to block. */
static void place(int i, double *x, double *y)
{
    int set = i / 16, block_x = i % 4, block_y = i % 16 / 4;
    int cell = (set + block_x + 2 * block_y) & 3;
    int column = 2 * block_x + (cell & 1), row = 2 * block_y + (cell >> 1);
    *x = (column + (row + 0.5) / 8) / 8;
    *y = (row + (column + 0.5) / 8) / 8;
}

/* Doubled area of the triangle of corners 0, i and i + 1. */
static double fan_area(const render_area_light *light, int i)
{
    render_area_light one = {.corner_count = 3};
    for (int k = 0; k < 3; k++) {
        one.corners[0][k] = light->corners[0][k];
        one.corners[1][k] = light->corners[i][k];
        one.corners[2][k] = light->corners[i + 1][k];
    }
    double n[3];
    shadows_normal(&one, n);
    return sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

static bool is_parallelogram(const render_area_light *light)
{
    if (light->corner_count != 4)
        return false;
    double off = 0, size = 0;
    for (int k = 0; k < 3; k++) {
        double diagonal = light->corners[2][k] - light->corners[0][k];
        double sum = light->corners[1][k] + light->corners[3][k] - 2 * light->corners[0][k];
        off = fmax(off, fabs(sum - diagonal));
        size = fmax(size, fabs(diagonal));
    }
    return off <= 1e-6 * size;
}

/* The unit square onto the polygon, equal areas to equal areas: a parallelogram as it is; else x
 * chooses the place in the fan around corner 0, y the distance from there. */
void shadows_point(const render_area_light *light, double x, double y, double p[3])
{
    const double(*c)[3] = light->corners;
    if (is_parallelogram(light)) {
        for (int k = 0; k < 3; k++)
            p[k] = c[0][k] + x * (c[1][k] - c[0][k]) + y * (c[3][k] - c[0][k]);
        return;
    }
    double all = 0;
    for (int i = 1; i + 1 < light->corner_count; i++)
        all += fan_area(light, i);
    int i = 1;
    double left = x * all, area = fan_area(light, 1);
    while (i + 2 < light->corner_count && left > area) {
        left -= area;
        area = fan_area(light, ++i);
    }
    double across = area > 0 ? fmin(left / area, 1) : 0, out = sqrt(y);
    for (int k = 0; k < 3; k++) {
        double rim = c[i][k] + across * (c[i + 1][k] - c[i][k]);
        p[k] = c[0][k] + out * (rim - c[0][k]);
    }
}

void shadows_points(const render_area_light *light, double lift, float points[SHADOWS_POINTS][4])
{
    double n[3];
    shadows_normal(light, n);
    double area = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int i = 0; i < SHADOWS_POINTS; i++) {
        double x, y, p[3];
        place(i, &x, &y);
        shadows_point(light, x, y, p);
        for (int k = 0; k < 3; k++)
            points[i][k] = (float)(p[k] + (area > 0 ? lift * n[k] / area : 0));
        points[i][3] = 0;
    }
}
