/* Area lights on the device, and ground truth: every pixel, all rays. */
#include "shadows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "internal.h"

/* struct Area of shaders/shadows/area.glsl. */
typedef struct area_data {
    float plane[4], exitance[4], middle[4];
    uint32_t range[4];
} area_data;

typedef struct host_lights {
    light_data *triangles;
    area_data *areas;
    float (*points)[4];
    uint32_t triangle_count, area_count;
} host_lights;

static void centroid(const render_area_light *light, double area, float middle[4])
{
    for (int i = 1; i + 1 < light->corner_count; i++) {
        render_area_light part = {.corner_count = 3};
        const int corners[3] = {0, i, i + 1};
        double n[3];
        for (int c = 0; c < 3; c++)
            memcpy(part.corners[c], light->corners[corners[c]], sizeof part.corners[c]);
        shadows_normal(&part, n);
        double share = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / area / 3;
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++)
                middle[k] += (float)(share * part.corners[c][k]);
    }
}

static void add_light(const render_area_light *light, host_lights *to)
{
    double n[3], size = 0;
    shadows_normal(light, n);
    double area = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(area > 0))
        return;
    area_data *a = &to->areas[to->area_count];
    *a = (area_data){.range = {to->triangle_count, (uint32_t)light->corner_count - 2, 0, 0}};
    a->plane[3] = (float)area;
    for (int k = 0; k < 3; k++) {
        a->plane[k] = (float)(n[k] / area);
        a->exitance[k] = (float)light->exitance[k];
    }
    for (int i = 1; i + 1 < light->corner_count; i++) {
        light_data *t = &to->triangles[to->triangle_count++];
        for (int k = 0; k < 3; k++) {
            t->a[k] = (float)light->corners[0][k];
            t->b[k] = (float)light->corners[i][k];
            t->c[k] = (float)light->corners[i + 1][k];
        }
        t->a[3] = a->exitance[0], t->b[3] = a->exitance[1], t->c[3] = a->exitance[2];
        memcpy(t->plane, a->plane, sizeof t->plane);
    }
    centroid(light, area, a->middle);
    for (int i = 0; i < light->corner_count; i++)
        for (int k = 0; k < 3; k++)
            size = fmax(size, fabs(light->corners[i][k]));
    /* as far from the light as shadow rays begin from a surface, see area.glsl */
    shadows_points(light, 1e-4 * size, to->points + (size_t)SHADOWS_POINTS * to->area_count++);
}

static gpu_status upload(gpu_device *device, const void *data, size_t size, gpu_buffer **buffer)
{
    gpu_status status = gpu_buffer_create(device, size, buffer);
    if (status == GPU_OK)
        memcpy(gpu_buffer_map(*buffer), data, size);
    return status;
}

static gpu_status create_lights(render_frame *frame, shadows *s)
{
    const render_scene *scene = frame->scene;
    size_t count = scene->area_light_count, corners = 0;
    for (size_t i = 0; i < count; i++)
        corners += (size_t)scene->area_lights[i].corner_count;
    host_lights lights = {.triangles = base_allocate((corners + 1) * sizeof *lights.triangles),
                          .areas = base_allocate((count + 1) * sizeof *lights.areas),
                          .points =
                              base_allocate((count + 1) * SHADOWS_POINTS * sizeof *lights.points)};
    for (size_t i = 0; i < count; i++)
        add_light(&scene->area_lights[i], &lights);
    s->light_count = lights.area_count;
    size_t size = lights.area_count * sizeof *lights.areas;
    uint32_t head[4] = {s->tracer.root, s->light_count, 0, 0};
    gpu_status status = upload(frame->device, lights.triangles,
                               lights.triangle_count * sizeof *lights.triangles, &s->triangles);
    if (status == GPU_OK)
        status = gpu_buffer_create(frame->device, sizeof head + size, &s->areas);
    if (status == GPU_OK) {
        memcpy(gpu_buffer_map(s->areas), head, sizeof head);
        memcpy((char *)gpu_buffer_map(s->areas) + sizeof head, lights.areas, size);
    }
    if (status == GPU_OK)
        status = upload(frame->device, lights.points,
                        lights.area_count * SHADOWS_POINTS * sizeof *lights.points, &s->points);
    free(lights.triangles);
    free(lights.areas);
    free(lights.points);
    return status;
}

gpu_status shadows_create(render_frame *frame, shadows *s)
{
    *s = (shadows){0};
    if (frame->scene->area_light_count == 0)
        return gpu_fail(GPU_UNSUPPORTED, "shadows are those of area lights, and \"%s\" has none",
                        frame->scene->name ? frame->scene->name : "the scene");
    return shadows_create_any(frame, s);
}

gpu_status shadows_create_any(render_frame *frame, shadows *s)
{
    enum { MOST_LIGHTS = 100000 }; /* whose points fill a buffer of 128 MiB */
    *s = (shadows){0};
    if (frame->scene->area_light_count > MOST_LIGHTS)
        return gpu_fail(GPU_UNSUPPORTED, "%zu area lights with shadows are more than %d",
                        frame->scene->area_light_count, MOST_LIGHTS);
    gpu_status status = render_tracer_create(frame->device, frame->scene, &s->tracer);
    if (status == GPU_OK)
        status = create_lights(frame, s);
    if (status != GPU_OK)
        shadows_destroy(s);
    return status;
}

void shadows_destroy(shadows *s)
{
    render_tracer_destroy(&s->tracer);
    gpu_buffer_destroy(s->triangles);
    gpu_buffer_destroy(s->areas);
    gpu_buffer_destroy(s->points);
    *s = (shadows){0};
}

gpu_status shadows_compute(render_frame *frame, const char *path, const gpu_binding *own, int count,
                           uint32_t push_size, gpu_compute **compute)
{
    gpu_binding bindings[GPU_MAX_BINDINGS] = {[7] = GPU_FETCHED, [8] = GPU_FETCHED};
    for (int i = 0; i < count; i++)
        bindings[SHADOWS_BINDINGS + i] = own[i];
    return render_compute(frame, path, false, bindings, SHADOWS_BINDINGS + count, push_size,
                          compute);
}

void shadows_bind(const render_frame *frame, const shadows *s, gpu_step *step)
{
    void *resources[SHADOWS_BINDINGS] = {
        frame->view,     s->triangles,        frame->counters, s->areas,     s->points,
        s->tracer.nodes, s->tracer.triangles, frame->position, frame->normal};
    memcpy(step->resources, resources, sizeof resources);
}

gpu_status shadows_run(render_frame *frame, const gpu_step *steps, int count,
                       render_statistics *statistics)
{
    enum { GAVE_UP = 13 }; /* of counters.glsl */
    gpu_status status = render_run(frame, steps, count, statistics);
    const uint32_t *halves = gpu_buffer_map(frame->counters);
    if (status == GPU_OK && (halves[2 * GAVE_UP] || halves[2 * GAVE_UP + 1]))
        return gpu_fail(GPU_FAILED,
                        "shadows: this device ends loops before all rays to %zu area "
                        "lights are traced",
                        frame->scene->area_light_count);
    return status;
}

/* ---- Ground truth -------------------------------------------------------------------- */

typedef struct reference {
    shadows shadows;
    gpu_compute *compute;
} reference;

static void destroy(void *state)
{
    reference *r = state;
    gpu_compute_destroy(r->compute);
    shadows_destroy(&r->shadows);
    free(r);
}

static gpu_status create(render_frame *frame, void **state)
{
    static const gpu_binding own[] = {GPU_STORAGE_IMAGE};
    *state = NULL;
    reference *r = base_allocate(sizeof *r);
    *r = (reference){0};
    gpu_status status = shadows_create(frame, &r->shadows);
    if (status == GPU_OK)
        status = shadows_compute(frame, "shadows/shadows.comp", own, 1, 12, &r->compute);
    if (status == GPU_OK)
        *state = r;
    else
        destroy(r);
    return status;
}

/* Push constants of shadows.comp. */
typedef struct strip_push {
    uint32_t first_row, first_light, last_light;
} strip_push;

/* In strips of rows, of the order of a second on a software device, and one light at a time, so
 * that no driver ends the loop over its rays. */
static gpu_status run(render_frame *frame, void *state, render_statistics *statistics)
{
    enum { WIDTH = 16, HEIGHT = 8 };
    static const double strip_rays = 2e6;
    const reference *r = state;
    uint32_t lights = r->shadows.light_count;
    uint32_t parts = lights ? lights : 1, rows = (frame->height + HEIGHT - 1) / HEIGHT;
    double row_rays = (double)frame->width * HEIGHT * SHADOWS_POINTS;
    uint32_t strip = (uint32_t)fmin(fmax(strip_rays / row_rays, 1), rows);
    uint32_t strips = (rows + strip - 1) / strip;
    size_t count = (size_t)strips * parts;
    gpu_step *steps = base_allocate(count * sizeof *steps);
    strip_push *push = base_allocate(count * sizeof *push);
    for (size_t i = 0; i < count; i++) {
        uint32_t row = (uint32_t)(i / parts) * strip, light = (uint32_t)(i % parts);
        push[i] = (strip_push){row * HEIGHT, light, light < lights ? light + 1 : lights};
        steps[i] = (gpu_step){.name = "shadows",
                              .compute = r->compute,
                              .push = &push[i],
                              .groups = {(frame->width + WIDTH - 1) / WIDTH,
                                         rows - row < strip ? rows - row : strip, 1}};
        shadows_bind(frame, &r->shadows, &steps[i]);
        steps[i].resources[SHADOWS_BINDINGS] = frame->light;
    }
    gpu_status status = shadows_run(frame, steps, (int)count, statistics);
    free(steps);
    free(push);
    return status;
}

const render_pipeline shadows_pipeline = {
    .id = "shadows",
    .title = "area lights with shadows, ground truth: every pixel, 64 rays to each light",
    .shadows = true,
    .create = create,
    .run = run,
    .destroy = destroy,
};
