/* scene_add.c: from a mesh to triangles of the scene that are safe to draw. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "scene_private.h"

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
    double place[3];
    scene_move(t, from, place);
    for (int i = 0; i < 3; i++)
        to[i] = (float)place[i];
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

static bool grow(void *array, size_t size)
{
    void *before, *after;
    memcpy(&before, array, sizeof before);
    after = realloc(before, size ? size : 1);
    if (after)
        memcpy(array, &after, sizeof after);
    return after != NULL;
}

static void select_triangles(const mesh *from, bool mirrored, moved_mesh *m)
{
    for (size_t t = 0; t < from->triangle_count; t++) {
        const uint32_t *index = &from->indices[3 * t];
        uint32_t corners[3] = {index[0], index[mirrored ? 2 : 1], index[mirrored ? 1 : 2]};
        double area[3];
        if (!scene_triangle_area(m->positions, corners, area))
            continue;
        memcpy(&m->corners[3 * m->triangle_count], corners, sizeof corners);
        m->materials[m->triangle_count++] = from->materials[t];
    }
}

static bool append(render_scene *scene, const mesh *from, const moved_mesh *m, const double *albedo)
{
    size_t v0 = scene->vertex_count, t0 = scene->triangle_count, m0 = scene->material_count;
    size_t materials = albedo ? 1 : from->material_count;
    if (v0 + m->made_count >= UINT32_MAX || t0 + m->triangle_count >= UINT32_MAX ||
        m0 + materials >= UINT32_MAX || !grow(&scene->positions, 12 * (v0 + m->made_count)) ||
        !grow(&scene->normals, 12 * (v0 + m->made_count)) ||
        !grow(&scene->indices, 12 * (t0 + m->triangle_count)) ||
        !grow(&scene->materials, 4 * (t0 + m->triangle_count)) ||
        !grow(&scene->albedos, 12 * (m0 + materials)))
        return false;
    for (size_t v = 0; v < m->made_count; v++) {
        memcpy(&scene->positions[3 * (v0 + v)], &m->positions[3 * (size_t)m->made[v].vertex], 12);
        memcpy(&scene->normals[3 * (v0 + v)], m->made[v].normal, 12);
    }
    for (size_t i = 0; i < 3 * m->triangle_count; i++)
        scene->indices[3 * t0 + i] = (uint32_t)v0 + m->indices[i];
    for (size_t t = 0; t < m->triangle_count; t++)
        scene->materials[t0 + t] = (uint32_t)m0 + (albedo ? 0 : m->materials[t]);
    for (size_t i = 0; i < 3 * materials; i++)
        scene->albedos[3 * m0 + i] = albedo ? (float)albedo[i] : from->albedos[i];
    scene->vertex_count += m->made_count;
    scene->triangle_count += m->triangle_count;
    scene->material_count += materials;
    scene->dropped_triangles += from->left_out + from->triangle_count - m->triangle_count;
    return true;
}

bool scene_add_mesh(render_scene *scene, const mesh *from, const scene_transform *transform,
                    const double *albedo)
{
    moved_mesh m = {.vertex_count = from->vertex_count};
    const double *s = transform->scale;
    size_t corners = 3 * from->triangle_count;
    bool good = grow(&m.positions, 12 * m.vertex_count) && grow(&m.normals, 12 * m.vertex_count) &&
                grow(&m.corners, 4 * corners) && grow(&m.indices, 4 * corners) &&
                grow(&m.materials, 4 * from->triangle_count) &&
                grow(&m.made, corners * sizeof *m.made);
    if (good) {
        for (size_t v = 0; v < from->vertex_count; v++) {
            move_vertex(transform, &from->positions[3 * v], &m.positions[3 * v]);
            move_normal(transform, &from->normals[3 * v], &m.normals[3 * v]);
        }
        select_triangles(from, s[0] * s[1] * s[2] < 0, &m);
        good = scene_make_vertices(&m) && append(scene, from, &m, albedo);
    }
    if (!good)
        base_error("out of memory for a mesh of %zu triangles", from->triangle_count);
    free(m.positions);
    free(m.normals);
    free(m.corners);
    free(m.materials);
    free(m.indices);
    free(m.made);
    return good;
}
