/* What shines, and what of it arrives. */
#include <stdlib.h>

#include "base/progress.h"
#include "reference_render.h"
#include "reference_vectors.h"

static const double pi = 3.14159265358979323846;

/* ---- Lights -------------------------------------------------------------------------------------
 */

/* Solid angle of a triangle seen from the origin (van Oosterom and Strackee). */
static double solid_angle(const double a[3], const double b[3], const double c[3])
{
    double across[3], la = sqrt(dot(a, a)), lb = sqrt(dot(b, b)), lc = sqrt(dot(c, c));
    cross(b, c, across);
    return 2 * atan2(fabs(dot(a, across)),
                     la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la);
}

static void make_texel_light(const render_spot *spot, const reference_pixel *hit, double angle,
                             reference_light *light)
{
    double to_light[3], axis[3] = {0}, s[3], t[3];
    int least = 0;
    subtract(spot->position, hit->position, to_light);
    double square = dot(to_light, to_light), cosine = dot(to_light, hit->face) / sqrt(square);
    double area = angle * square / fmax(cosine, 0.05);
    for (int i = 0; i < 3; i++) {
        light->exitance[i] =
            rint(255 * (double)hit->albedo[i]) / 255 * spot->intensity[i] * angle / area;
        /* what differs by the rounding of a normal is the same */
        least = fabs(hit->face[i]) < fabs(hit->face[least]) - 1e-3 ? i : least;
    }
    axis[least] = 1;
    memcpy(light->normal, hit->face, sizeof light->normal);
    cross(axis, hit->face, s);
    normalise(s);
    cross(hit->face, s, t);
    double edge = sqrt(4 * area / sqrt(3));
    for (int i = 0; i < 3; i++) {
        double base = hit->position[i] - edge / sqrt(12) * t[i];
        light->corners[0][i] = base - edge / 2 * s[i];
        light->corners[1][i] = base + edge / 2 * s[i];
        light->corners[2][i] = hit->position[i] + edge / sqrt(3) * t[i];
    }
}

static size_t add_texels(reference *from, reference_light *lights)
{
    const render_scene *scene = reference_scene(from);
    const render_spot *spot = &scene->spot;
    int n = scene->rsm_size;
    double along[3], steep = tan(spot->angle_deg / 2 * pi / 180), farthest = 0;
    subtract(spot->target, spot->position, along);
    bool upright = fabs(along[1]) > 0.99 * sqrt(dot(along, along));
    for (int corner = 0; corner < 8; corner++) {
        double p[3];
        for (int i = 0; i < 3; i++)
            p[i] = (corner >> i & 1 ? scene->high[i] : scene->low[i]) - spot->position[i];
        farthest = fmax(farthest, sqrt(dot(p, p)));
    }
    render_camera camera = {.up = {0, upright ? 0 : 1, upright ? 1 : 0},
                            .fov_y_deg = spot->angle_deg,
                            .near = 1e-3 * (1.01 * farthest + 1e-3),
                            .far = 1.01 * farthest + 1e-3};
    memcpy(camera.eye, spot->position, sizeof camera.eye);
    memcpy(camera.target, spot->target, sizeof camera.target);
    reference_pixel *map = calloc((size_t)n * (size_t)n, sizeof *map);
    size_t count = 0;
    if (!map)
        return 0;
    reference_view(from, &camera, n, n, map);
    for (int i = 0; i < n * n; i++) {
        double corners[4][3]; /* of the texel, in the plane at distance 1 */
        for (int k = 0; k < 4; k++) {
            corners[k][0] = steep * (2.0 * (i % n + (k & 1)) / n - 1);
            corners[k][1] = steep * (2.0 * (i / n + (k >> 1)) / n - 1);
            corners[k][2] = 1;
        }
        double angle = solid_angle(corners[0], corners[1], corners[2]) +
                       solid_angle(corners[1], corners[2], corners[3]);
        if (map[i].depth > 0)
            make_texel_light(spot, &map[i], angle, &lights[count++]);
    }
    free(map);
    return count;
}

reference_light *reference_lights(reference *from, size_t *count)
{
    const render_scene *scene = reference_scene(from);
    size_t most = 1 + (size_t)scene->rsm_size * (size_t)scene->rsm_size +
                  RENDER_MOST_CORNERS * scene->area_light_count;
    reference_light *lights = calloc(most, sizeof *lights);
    *count = lights && scene->has_spot ? add_texels(from, lights) : 0;
    for (size_t i = 0; lights && i < scene->area_light_count; i++) {
        const render_area_light *area = &scene->area_lights[i];
        for (int k = 1; k + 1 < area->corner_count; k++) {
            reference_light *light = &lights[(*count)++];
            double a[3], b[3];
            memcpy(light->corners[0], area->corners[0], sizeof light->corners[0]);
            memcpy(light->corners[1], area->corners[k], sizeof light->corners[0]);
            memcpy(light->corners[2], area->corners[k + 1], sizeof light->corners[0]);
            memcpy(light->exitance, area->exitance, sizeof light->exitance);
            subtract(light->corners[1], light->corners[0], a);
            subtract(light->corners[2], light->corners[0], b);
            cross(a, b, light->normal);
            if (!(normalise(light->normal) > 0)) /* a corner on an edge */
                (*count)--;
        }
    }
    return lights;
}

/* ---- Irradiance ---------------------------------------------------------------------------------
 */

double reference_form_factor(const reference_light *light, const double x[3], const double n[3])
{
    double polygon[4][3], heights[3], from_plane[3];
    subtract(x, light->corners[0], from_plane);
    if (dot(from_plane, light->normal) < 0.002)
        return 0;
    int corners = 0;
    for (int k = 0; k < 3; k++) {
        double v[3];
        subtract(light->corners[k], x, v);
        heights[k] = dot(v, n);
    }
    for (int k = 0; k < 3; k++) { /* what is above the horizon, seen from x */
        int next = (k + 1) % 3;
        if (heights[k] >= 0)
            subtract(light->corners[k], x, polygon[corners++]);
        if ((heights[k] > 0 && heights[next] < 0) || (heights[k] < 0 && heights[next] > 0)) {
            double at = heights[k] / (heights[k] - heights[next]);
            for (int i = 0; i < 3; i++)
                polygon[corners][i] = light->corners[k][i] - x[i] +
                                      at * (light->corners[next][i] - light->corners[k][i]);
            corners++;
        }
    }
    double sum = 0;
    for (int k = 0; corners >= 3 && k < corners; k++) {
        double across[3];
        /* counter-clockwise seen from x: the inner normal of an edge is next x this */
        cross(polygon[(k + 1) % corners], polygon[k], across);
        double length = sqrt(dot(across, across));
        double angle = atan2(length, dot(polygon[k], polygon[(k + 1) % corners]));
        sum += length > 0 ? angle * dot(across, n) / length : 0;
    }
    return fmax(sum, 0) / (2 * pi);
}

typedef struct irradiance_job {
    const reference_pixel *pixels;
    const reference_light *lights;
    size_t light_count;
    double (*rgb)[3];
} irradiance_job;

static void irradiance_at(void *context, size_t i)
{
    const irradiance_job *job = context;
    double sum[3] = {0};
    for (size_t l = 0; job->pixels[i].depth > 0 && l < job->light_count; l++) {
        double factor =
            reference_form_factor(&job->lights[l], job->pixels[i].position, job->pixels[i].normal);
        for (int c = 0; c < 3; c++)
            sum[c] += factor * job->lights[l].exitance[c];
    }
    memcpy(job->rgb[i], sum, sizeof sum);
}

void reference_irradiance(const reference_pixel *pixels, size_t pixel_count,
                          const reference_light *lights, size_t light_count, double (*rgb)[3])
{
    irradiance_job job = {pixels, lights, light_count, rgb};
    base_parallel(pixel_count, irradiance_at, &job);
}
