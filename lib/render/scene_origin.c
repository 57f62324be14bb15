/* scene_origin.c: where the scene's own coordinates begin. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "scene_private.h"

/* In radii of the bounds: nearer ones keep the description's coordinates to the bit, and floats
 * still tell 1e-6 radii apart. Rounding the origin leaves at most 9 of them. */
static const double farthest = 16;

void scene_move(const scene_transform *t, const float from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = t->rotation[i][0] * t->scale[0] * (double)from[0] +
                t->rotation[i][1] * t->scale[1] * (double)from[1] +
                t->rotation[i][2] * t->scale[2] * (double)from[2] + t->translation[i];
}

/* Grows the bounds by the triangles whose corners are all finite. */
static void add_bounds(const scene_part *part, double low[3], double high[3])
{
    const mesh *from = &part->from;
    for (size_t t = 0; t < from->triangle_count; t++) {
        double corners[3][3];
        bool finite = true;
        for (size_t c = 0; c < 3; c++) {
            scene_move(&part->transform, &from->positions[3 * (size_t)from->indices[3 * t + c]],
                       corners[c]);
            for (int i = 0; i < 3; i++)
                finite = finite && isfinite(corners[c][i]);
        }
        for (int c = 0; finite && c < 3; c++)
            for (int i = 0; i < 3; i++) {
                low[i] = fmin(low[i], corners[c][i]);
                high[i] = fmax(high[i], corners[c][i]);
            }
    }
}

/* To a multiple of a power of ten: 10^power. */
static double round_to(double value, int power)
{
    double unit = pow(10, abs(power));
    return power < 0 ? round(value * unit) / unit : round(value / unit) * unit;
}

void scene_find_origin(const scene_part *parts, size_t count, double origin[3])
{
    double low[3] = {DBL_MAX, DBL_MAX, DBL_MAX}, high[3] = {-DBL_MAX, -DBL_MAX, -DBL_MAX};
    double middle[3], away = 0, square = 0;
    origin[0] = origin[1] = origin[2] = 0;
    for (size_t i = 0; i < count; i++)
        add_bounds(&parts[i], low, high);
    if (!(low[0] <= high[0]))
        return;
    for (int i = 0; i < 3; i++) {
        middle[i] = low[i] / 2 + high[i] / 2;
        away += middle[i] * middle[i];
        square += pow(high[i] / 2 - low[i] / 2, 2);
    }
    double radius = sqrt(square);
    if (!(radius > 0) || !isfinite(away) || !(sqrt(away) > farthest * radius))
        return;
    int power = (int)fmax(ceil(log10(radius)), -15);
    for (int i = 0; i < 3; i++)
        origin[i] = round_to(middle[i], power);
}
