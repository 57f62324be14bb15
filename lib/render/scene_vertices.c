/* scene_vertices.c: vertices as they are drawn, with normals made where a mesh has none. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene_private.h"

enum { NONE = 0xffffffff, MOST_ALIKE = 4096 };

/* Faces that meet at more than 60 degrees keep the edge between them. */
static const double cosine_of_edge = 0.5;

/* Twice the area, as a vector; false where the triangle is none that can be drawn. */
bool scene_triangle_area(const float *positions, const uint32_t corners[3], double area[3])
{
    const float *a = &positions[3 * (size_t)corners[0]], *b = &positions[3 * (size_t)corners[1]],
                *c = &positions[3 * (size_t)corners[2]];
    double ab[3], ac[3];
    double longest = 0;
    for (int i = 0; i < 3; i++) {
        ab[i] = (double)b[i] - (double)a[i];
        ac[i] = (double)c[i] - (double)a[i];
        longest = fmax(longest, fmax(fabs(ab[i]), fabs(ac[i])));
    }
    scene_cross(ab, ac, area);
    double twice = sqrt(scene_dot(area, area));
    /* Thinner than the rounding of its own corners: its plane means nothing. */
    return isfinite(twice) && twice > 1e-12 * longest * longest && twice > 1e-30;
}

/* A corner of a triangle that stays, of a vertex that has no normal. */
typedef struct open_corner {
    float position[3];
    uint32_t corner; /* 3*triangle + k */
} open_corner;

static int compare(const void *a, const void *b)
{
    const open_corner *x = a, *y = b;
    for (int i = 0; i < 3; i++)
        if (x->position[i] != y->position[i])
            return x->position[i] < y->position[i] ? -1 : 1;
    return x->corner < y->corner ? -1 : x->corner > y->corner;
}

static double cosine_between(const double a[3], const double b[3])
{
    return scene_dot(a, b) / sqrt(scene_dot(a, a) * scene_dot(b, b));
}

static void normalise(const double sum[3], const double otherwise[3], float normal[3])
{
    double length = sqrt(scene_dot(sum, sum));
    const double *from = length > 0 ? sum : otherwise;
    length = sqrt(scene_dot(from, from));
    for (int i = 0; i < 3; i++)
        normal[i] = (float)(from[i] / length);
}

/* The corners of one place: each gets the mean of the faces there that are not beyond an edge from
 * its own, weighted by area; corners with the same normal share a vertex. */
static void make_place(moved_mesh *m, const open_corner *corners, size_t count, double (*areas)[3])
{
    size_t first = m->made_count;
    for (size_t i = 0; i < count; i++)
        scene_triangle_area(m->positions, &m->corners[3 * (corners[i].corner / 3)], areas[i]);
    for (size_t i = 0; i < count; i++) {
        double sum[3] = {0};
        for (size_t j = 0; count <= MOST_ALIKE && j < count; j++)
            if (cosine_between(areas[i], areas[j]) >= cosine_of_edge || i == j)
                for (int k = 0; k < 3; k++)
                    sum[k] += areas[j][k];
        made_vertex made = {.vertex = m->corners[corners[i].corner]};
        normalise(sum, areas[i], made.normal);
        size_t v = count <= MOST_ALIKE ? first : m->made_count;
        while (v < m->made_count && memcmp(m->made[v].normal, made.normal, sizeof made.normal) != 0)
            v++;
        if (v == m->made_count)
            m->made[m->made_count++] = made;
        m->indices[corners[i].corner] = (uint32_t)v;
    }
}

static void make_places(moved_mesh *m, open_corner *corners, size_t count, double (*areas)[3])
{
    qsort(corners, count, sizeof *corners, compare);
    for (size_t i = 0, end; i < count; i = end) {
        for (end = i + 1; end < count; end++) {
            const float *a = corners[i].position, *b = corners[end].position;
            if (a[0] != b[0] || a[1] != b[1] || a[2] != b[2])
                break;
        }
        make_place(m, &corners[i], end - i, areas);
    }
}

bool scene_make_vertices(moved_mesh *m)
{
    size_t corner_count = 3 * m->triangle_count, open_count = 0;
    uint32_t *renamed = malloc((m->vertex_count + 1) * sizeof *renamed);
    open_corner *open = malloc((corner_count + 1) * sizeof *open);
    double(*areas)[3] = malloc((corner_count + 1) * sizeof *areas);
    bool good = renamed && open && areas;
    for (size_t v = 0; good && v < m->vertex_count; v++)
        renamed[v] = NONE;
    for (size_t i = 0; good && i < corner_count; i++) {
        uint32_t v = m->corners[i];
        const float *normal = &m->normals[3 * (size_t)v], *p = &m->positions[3 * (size_t)v];
        if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0) {
            open[open_count++] = (open_corner){{p[0], p[1], p[2]}, (uint32_t)i};
            continue;
        }
        if (renamed[v] == NONE) {
            made_vertex made = {.vertex = v, .normal = {normal[0], normal[1], normal[2]}};
            renamed[v] = (uint32_t)m->made_count;
            m->made[m->made_count++] = made;
        }
        m->indices[i] = renamed[v];
    }
    if (good)
        make_places(m, open, open_count, areas);
    free(renamed);
    free(open);
    free(areas);
    return good;
}
