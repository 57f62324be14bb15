/* Poisson-disk samples on triangles. */
#include "lpv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/random.h"

/* ---- Darts ---------------------------------------------------------------------------- */

static const float *corner(const float *values, const render_scene *scene, size_t triangle,
                           size_t i)
{
    return values + 3 * (size_t)scene->indices[3 * triangle + i];
}

/* Unit normal by the order of the corners; returns the area. */
static double face_of(const render_scene *scene, size_t triangle, double normal[3])
{
    double e[2][3];
    for (size_t i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            e[i][k] = (double)corner(scene->positions, scene, triangle, i + 1)[k] -
                      (double)corner(scene->positions, scene, triangle, 0)[k];
    for (int k = 0; k < 3; k++)
        normal[k] = e[0][(k + 1) % 3] * e[1][(k + 2) % 3] - e[0][(k + 2) % 3] * e[1][(k + 1) % 3];
    double twice = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (!(twice > 0) || !isfinite(twice))
        return 0;
    for (int k = 0; k < 3; k++)
        normal[k] /= twice;
    return 0.5 * twice;
}

/* What a dart needs to become a sample. */
typedef struct place {
    uint32_t triangle;
    float weights[3];
} place;

/* Number i within a triangle: even where there are many (Roberts' sequence of two dimensions,
 * folded along the diagonal). */
static void weigh(uint64_t i, double shift, float weights[3])
{
    double whole, u = modf(0.5 + shift + 0.75487766624669276 * (double)i, &whole),
                  v = modf(0.5 + shift + 0.56984029099805327 * (double)i, &whole);
    if (u + v > 1)
        u = 1 - u, v = 1 - v;
    weights[0] = (float)(1 - u - v);
    weights[1] = (float)u;
    weights[2] = (float)v;
}

static void throw_darts(const render_scene *scene, lpv_samples *s, place *places)
{
    uint64_t seed = 1, index = 0;
    double before = 0, next = base_uniform(&seed), normal[3];
    size_t made = 0;
    for (size_t t = 0; t < scene->triangle_count && made < s->dart_count; t++) {
        double area = face_of(scene, t, normal), shift = base_uniform(&seed);
        before += area / s->dart_area;
        /* one dart in each unit of area, at a random place of it; the sum may end a little short */
        for (index = 0; made < s->dart_count &&
                        ((double)made + next < before || t + 1 == scene->triangle_count);
             index++) {
            places[made].triangle = (uint32_t)t;
            weigh(index, shift, places[made].weights);
            lpv_dart *dart = &s->darts[made++];
            for (int k = 0; k < 3; k++) {
                dart->position[k] = 0;
                for (size_t i = 0; i < 3; i++)
                    dart->position[k] +=
                        places[made - 1].weights[i] * corner(scene->positions, scene, t, i)[k];
                dart->face[k] = (float)normal[k];
            }
            next = base_uniform(&seed);
        }
    }
}

/* ---- Choosing ------------------------------------------------------------------------- */

/* Cells of the radius' side, hashed: chains of samples. Two cells may share a chain: distances tell
 * them apart. */
typedef struct grid {
    double side;
    size_t mask;
    uint32_t *heads, *next; /* UINT32_MAX: none */
} grid;

static size_t cell_of(const grid *g, const float p[3], const int offset[3])
{
    uint64_t hash = 0;
    for (int k = 0; k < 3; k++) {
        int64_t cell = (int64_t)floor((double)p[k] / g->side) + offset[k];
        hash = (hash ^ (uint64_t)cell) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return (size_t)hash & g->mask;
}

/* The sample within the radius that is nearest, one that faces elsewhere counting as farther;
 * UINT32_MAX: none is within it. */
static uint32_t nearest(const grid *g, const lpv_samples *s, const lpv_dart *dart)
{
    uint32_t found = UINT32_MAX;
    double least = INFINITY;
    for (int cell = 0; cell < 27; cell++) {
        int offset[3] = {cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1};
        uint32_t i = g->heads[cell_of(g, dart->position, offset)];
        for (; i != UINT32_MAX; i = g->next[i]) {
            double square = 0, along = 0;
            for (int k = 0; k < 3; k++) {
                double d = (double)dart->position[k] - (double)s->samples[i].position[k];
                square += d * d;
                along += (double)dart->face[k] * (double)s->samples[i].face[k];
            }
            double cost = square + s->radius * s->radius * (1 - fabs(along));
            if (square < s->radius * s->radius && (cost < least || (cost <= least && i < found))) {
                least = cost;
                found = i;
            }
        }
    }
    return found;
}

static void keep(const render_scene *scene, const lpv_dart *dart, const place *place, grid *g,
                 lpv_samples *s)
{
    lpv_sample *sample = &s->samples[s->count];
    *sample = (lpv_sample){.position = {0}};
    double side = 0, size = 0;
    float normal[3] = {0, 0, 0};
    for (size_t k = 0; k < 3; k++) {
        for (size_t i = 0; i < 3; i++)
            normal[k] += place->weights[i] * corner(scene->normals, scene, place->triangle, i)[k];
        sample->position[k] = dart->position[k];
        sample->face[k] = dart->face[k];
        sample->albedo[k] = scene->albedos[3 * (size_t)scene->materials[place->triangle] + k];
        side += (double)normal[k] * (double)dart->face[k];
        size += (double)normal[k] * (double)normal[k];
    }
    size = size > 0.25 ? (side < 0 ? -sqrt(size) : sqrt(size)) : 0;
    for (int k = 0; k < 3; k++)
        sample->normal[k] = size != 0 ? normal[k] / (float)size : dart->face[k];
    size_t cell = cell_of(g, dart->position, (int[3]){0, 0, 0});
    g->next[s->count] = g->heads[cell];
    g->heads[cell] = (uint32_t)s->count++;
}

static size_t common_factor(size_t a, size_t b)
{
    while (b) {
        size_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* False where there would be more than most. */
static bool choose(const render_scene *scene, const place *places, size_t most, lpv_samples *s)
{
    grid g = {.side = s->radius, .mask = 1};
    while (g.mask < 2 * most)
        g.mask *= 2;
    g.heads = base_allocate(g.mask * sizeof *g.heads);
    g.next = base_allocate(most * sizeof *g.next);
    memset(g.heads, 0xff, g.mask-- * sizeof *g.heads);
    /* every dart once, by steps that share no factor with their number */
    size_t count = s->dart_count, stride = (size_t)(0.6180339887498949 * (double)count) | 1, at = 0;
    while (common_factor(stride, count) != 1)
        stride += 2;
    bool fits = true;
    s->count = 0;
    for (size_t i = 0; i < count && fits; i++, at = (at + stride) % count)
        if (nearest(&g, s, &s->darts[at]) == UINT32_MAX) {
            fits = s->count < most;
            if (fits)
                keep(scene, &s->darts[at], &places[at], &g, s);
        }
    for (size_t i = 0; i < count && fits; i++) {
        s->darts[i].sample = nearest(&g, s, &s->darts[i]);
        s->samples[s->darts[i].sample].position[3] += (float)s->dart_area;
    }
    free(g.heads);
    free(g.next);
    return fits;
}

void lpv_samples_make(const render_scene *scene, size_t wanted, size_t darts, lpv_samples *s)
{
    double area = 0, normal[3];
    for (size_t t = 0; t < scene->triangle_count; t++)
        area += face_of(scene, t, normal);
    *s = (lpv_samples){0};
    if (!(area > 0) || !isfinite(area) || wanted == 0)
        return;
    s->dart_count = darts < wanted ? wanted : darts;
    s->dart_area = area / (double)s->dart_count;
    size_t most = 2 * wanted;
    s->darts = base_allocate(s->dart_count * sizeof *s->darts);
    s->samples = base_allocate(most * sizeof *s->samples);
    place *places = base_allocate(s->dart_count * sizeof *places);
    throw_darts(scene, s, places);
    /* between surfaces that lie apart the discs reach into nothing: then there are too many */
    s->radius = 0.85 * sqrt(area / (double)wanted);
    while (!choose(scene, places, most, s))
        s->radius *= 1.25;
    free(places);
}

void lpv_samples_free(lpv_samples *s)
{
    free(s->samples);
    free(s->darts);
    *s = (lpv_samples){0};
}
