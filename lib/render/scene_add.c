/* scene_add.c: from a mesh to triangles of the scene that are safe to draw. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "scene_private.h"

enum { UNUSED = 0xffffffff };

void scene_rotation(const double degrees[3], double r[3][3])
{
    double c[3], s[3];
    for (int i = 0; i < 3; i++) {
        /* Quarter turns are exact: walls stay where they are. */
        double turns = degrees[i] / 90, angle = degrees[i] * 3.14159265358979323846 / 180;
        double quarter = fmod(turns, 4);
        bool exact = turns == floor(turns);
        c[i] = !exact ? cos(angle) : fmod(quarter, 2) != 0 ? 0 : quarter == 0 ? 1 : -1;
        s[i] = !exact                          ? sin(angle)
               : fmod(quarter, 2) == 0         ? 0
               : quarter == 1 || quarter == -3 ? 1
                                               : -1;
    }
    const double product[3][3] = {
        {c[2] * c[1], c[2] * s[1] * s[0] - s[2] * c[0], c[2] * s[1] * c[0] + s[2] * s[0]},
        {s[2] * c[1], s[2] * s[1] * s[0] + c[2] * c[0], s[2] * s[1] * c[0] - c[2] * s[0]},
        {-s[1], c[1] * s[0], c[1] * c[0]}};
    memcpy(r, product, sizeof product);
}

static void move_vertex(const scene_transform *t, const float *from, float *to)
{
    for (int i = 0; i < 3; i++)
        to[i] = (float)(t->rotation[i][0] * t->scale[0] * (double)from[0] +
                        t->rotation[i][1] * t->scale[1] * (double)from[1] +
                        t->rotation[i][2] * t->scale[2] * (double)from[2] + t->translation[i]);
}

/* With the cofactors of the scale; 0 where there is none. */
static void move_normal(const scene_transform *t, const float *from, float *to)
{
    double n[3] = {(double)from[0] * t->scale[1] * t->scale[2],
                   (double)from[1] * t->scale[2] * t->scale[0],
                   (double)from[2] * t->scale[0] * t->scale[1]};
    double length = sqrt(scene_dot(n, n));
    for (int i = 0; i < 3; i++)
        to[i] = isfinite(length) && length > 0 ? (float)(scene_dot(t->rotation[i], n) / length) : 0;
}

/* Twice the area, as a vector; false where the triangle is none that can be drawn. */
static bool area_of(const float *positions, const uint32_t corners[3], double area[3])
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

/* Moved vertices and which of them are used, in the order of their first use. */
typedef struct moved {
    float *positions, *normals;
    uint32_t *renamed;
    uint32_t *corners; /* of the triangles that stay */
    uint32_t *materials;
    size_t vertices, triangles;
} moved;

static bool grow(void *array, size_t size)
{
    void *before, *after;
    memcpy(&before, array, sizeof before);
    after = realloc(before, size ? size : 1);
    if (after)
        memcpy(array, &after, sizeof after);
    return after != NULL;
}

static void select_triangles(const mesh *from, bool mirrored, moved *m)
{
    for (size_t t = 0; t < from->triangle_count; t++) {
        const uint32_t *index = &from->indices[3 * t];
        uint32_t corners[3] = {index[0], index[mirrored ? 2 : 1], index[mirrored ? 1 : 2]};
        double area[3];
        if (!area_of(m->positions, corners, area))
            continue;
        for (int k = 0; k < 3; k++) {
            uint32_t *renamed = &m->renamed[corners[k]];
            if (*renamed == UNUSED)
                *renamed = (uint32_t)m->vertices++;
            m->corners[3 * m->triangles + (size_t)k] = corners[k];
        }
        m->materials[m->triangles++] = from->materials[t];
    }
}

/* Every vertex that has no normal gets the mean of its triangles', weighted by area. */
static void make_normals(const mesh *from, moved *m)
{
    bool *missing = calloc(from->vertex_count + 1, sizeof *missing);
    for (size_t v = 0; missing && v < from->vertex_count; v++)
        missing[v] =
            m->normals[3 * v] == 0 && m->normals[3 * v + 1] == 0 && m->normals[3 * v + 2] == 0;
    for (size_t t = 0; missing && t < m->triangles; t++) {
        double area[3];
        area_of(m->positions, &m->corners[3 * t], area);
        for (size_t k = 0; k < 3; k++) {
            size_t v = m->corners[3 * t + k];
            for (size_t i = 0; missing[v] && i < 3; i++)
                m->normals[3 * v + i] += (float)area[i];
        }
    }
    for (size_t v = 0; missing && v < from->vertex_count; v++) {
        double n[3] = {(double)m->normals[3 * v], (double)m->normals[3 * v + 1],
                       (double)m->normals[3 * v + 2]};
        double length = sqrt(scene_dot(n, n));
        if (missing[v] && !(length > 1e-30)) {
            n[1] = length = 1; /* its triangles cancel out: any direction is as good */
            n[0] = n[2] = 0;
        }
        for (size_t i = 0; missing[v] && i < 3; i++)
            m->normals[3 * v + i] = (float)(n[i] / length);
    }
    free(missing);
}

static bool append(render_scene *scene, const mesh *from, const moved *m, const double *albedo)
{
    size_t v0 = scene->vertex_count, t0 = scene->triangle_count, m0 = scene->material_count;
    size_t materials = albedo ? 1 : from->material_count;
    if (v0 + m->vertices >= UNUSED || t0 + m->triangles >= UNUSED || m0 + materials >= UNUSED ||
        !grow(&scene->positions, 12 * (v0 + m->vertices)) ||
        !grow(&scene->normals, 12 * (v0 + m->vertices)) ||
        !grow(&scene->indices, 12 * (t0 + m->triangles)) ||
        !grow(&scene->materials, 4 * (t0 + m->triangles)) ||
        !grow(&scene->albedos, 12 * (m0 + materials)))
        return false;
    for (size_t v = 0; v < from->vertex_count; v++) {
        if (m->renamed[v] == UNUSED)
            continue;
        size_t to = 3 * (v0 + m->renamed[v]);
        memcpy(&scene->positions[to], &m->positions[3 * v], 12);
        memcpy(&scene->normals[to], &m->normals[3 * v], 12);
    }
    for (size_t i = 0; i < 3 * m->triangles; i++)
        scene->indices[3 * t0 + i] = (uint32_t)(v0 + m->renamed[m->corners[i]]);
    for (size_t t = 0; t < m->triangles; t++)
        scene->materials[t0 + t] = (uint32_t)(m0 + (albedo ? 0 : m->materials[t]));
    for (size_t i = 0; i < 3 * materials; i++)
        scene->albedos[3 * m0 + i] = albedo ? (float)albedo[i] : from->albedos[i];
    scene->vertex_count += m->vertices;
    scene->triangle_count += m->triangles;
    scene->material_count += materials;
    scene->dropped_triangles += from->left_out + from->triangle_count - m->triangles;
    return true;
}

bool scene_add_mesh(render_scene *scene, const mesh *from, const scene_transform *transform,
                    const double *albedo)
{
    moved m = {0};
    const double *s = transform->scale;
    bool good =
        grow(&m.positions, 12 * from->vertex_count) && grow(&m.normals, 12 * from->vertex_count) &&
        grow(&m.renamed, 4 * from->vertex_count) && grow(&m.corners, 12 * from->triangle_count) &&
        grow(&m.materials, 4 * from->triangle_count);
    for (size_t v = 0; good && v < from->vertex_count; v++) {
        move_vertex(transform, &from->positions[3 * v], &m.positions[3 * v]);
        move_normal(transform, &from->normals[3 * v], &m.normals[3 * v]);
        m.renamed[v] = UNUSED;
    }
    if (good) {
        select_triangles(from, s[0] * s[1] * s[2] < 0, &m);
        make_normals(from, &m);
        good = append(scene, from, &m, albedo);
    }
    if (!good)
        base_error("out of memory for a mesh of %zu triangles", from->triangle_count);
    free(m.positions);
    free(m.normals);
    free(m.renamed);
    free(m.corners);
    free(m.materials);
    return good;
}
