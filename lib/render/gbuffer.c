/* The scene's triangles on the device, drawn into position, normals and albedo. */
#include "internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/order.h"

gpu_status gbuffer_create(gpu_device *device, uint32_t width, uint32_t height, gbuffer *images)
{
    *images = (gbuffer){0};
    gpu_status status = gpu_image_create(device, GPU_RGBA32F, width, height, &images->position);
    if (status == GPU_OK)
        status = gpu_image_create(device, GPU_RG32U, width, height, &images->normal);
    if (status == GPU_OK)
        status = gpu_image_create(device, GPU_RGBA8, width, height, &images->albedo);
    if (status == GPU_OK)
        status = gpu_image_create(device, GPU_DEPTH32, width, height, &images->depth);
    return status;
}

void gbuffer_destroy(gbuffer *images)
{
    gpu_image_destroy(images->position);
    gpu_image_destroy(images->normal);
    gpu_image_destroy(images->albedo);
    gpu_image_destroy(images->depth);
    *images = (gbuffer){0};
}

/* An empty array still needs a buffer that can be bound. */
static gpu_status upload(gpu_device *device, const void *bytes, size_t size, gpu_buffer **buffer)
{
    gpu_status status = gpu_buffer_create(device, size ? size : 16, buffer);
    if (status == GPU_OK && size)
        memcpy(gpu_buffer_map(*buffer), bytes, size);
    return status;
}

/* The normal of a triangle by the order of its corners: of length 1, 0 for one without area, NaN
 * where a corner is not finite. */
static void face_normal(const render_scene *scene, size_t triangle, float normal[3])
{
    const float *corners[3];
    double side[2][3], across[3], square = 0;
    for (size_t corner = 0; corner < 3; corner++)
        corners[corner] = scene->positions + 3 * (size_t)scene->indices[3 * triangle + corner];
    for (int i = 0; i < 3; i++) {
        side[0][i] = (double)corners[1][i] - (double)corners[0][i];
        side[1][i] = (double)corners[2][i] - (double)corners[0][i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        across[i] = side[0][j] * side[1][k] - side[0][k] * side[1][j];
        square += across[i] * across[i];
    }
    double scale = isfinite(square) ? square > 0 ? 1 / sqrt(square) : 0 : (double)NAN;
    for (int i = 0; i < 3; i++)
        normal[i] = isnan(scale) ? NAN : (float)(across[i] * scale);
}

static gpu_status upload_faces(geometry *out, const render_scene *scene)
{
    float *faces = base_allocate((scene->triangle_count + 1) * 3 * sizeof *faces);
    for (size_t i = 0; i < scene->triangle_count; i++)
        face_normal(scene, i, faces + 3 * i);
    gpu_status status =
        upload(out->device, faces, scene->triangle_count * 3 * sizeof *faces, &out->faces);
    free(faces);
    return status;
}

gpu_status geometry_create(gpu_device *device, const render_scene *scene, geometry *out)
{
    *out = (geometry){.device = device, .corner_count = (uint32_t)(3 * scene->triangle_count)};
    const struct {
        const void *bytes;
        size_t size;
        gpu_buffer **buffer;
    } arrays[] = {
        {scene->positions, 3 * sizeof(float) * scene->vertex_count, &out->positions},
        {scene->normals, 3 * sizeof(float) * scene->vertex_count, &out->normals},
        {scene->indices, 3 * sizeof(uint32_t) * scene->triangle_count, &out->indices},
        {scene->materials, sizeof(uint32_t) * scene->triangle_count, &out->materials},
        {scene->albedos, 3 * sizeof(float) * scene->material_count, &out->albedos},
    };
    gpu_status status = GPU_OK;
    for (size_t i = 0; status == GPU_OK && i < sizeof arrays / sizeof *arrays; i++) {
        gpu_needs needs = {.buffer_bytes = arrays[i].size};
        status = gpu_check(device, &needs);
        if (status == GPU_OK)
            status = upload(device, arrays[i].bytes, arrays[i].size, arrays[i].buffer);
    }
    if (status == GPU_OK)
        status = upload_faces(out, scene);
    if (status != GPU_OK)
        return status;
    gpu_draw_options options = {
        .name = "gbuffer",
        .vertex = render_shader("gbuffer/gbuffer.vert"),
        .fragment = render_shader("gbuffer/gbuffer.frag"),
        .binding_count = 7, /* all of them storage buffers */
        .push_size = sizeof(uint32_t),
        .target_count = 3,
        .targets = {GPU_RGBA32F, GPU_RG32U, GPU_RGBA8},
        .depth = true,
    };
    return gpu_draw_create(device, &options, &out->draw);
}

void geometry_destroy(geometry *geometry)
{
    gpu_draw_destroy(geometry->draw);
    gpu_buffer_destroy(geometry->positions);
    gpu_buffer_destroy(geometry->normals);
    gpu_buffer_destroy(geometry->indices);
    gpu_buffer_destroy(geometry->materials);
    gpu_buffer_destroy(geometry->albedos);
    gpu_buffer_destroy(geometry->faces);
}

gpu_status geometry_draw(const geometry *geometry, gpu_buffer *view, const gbuffer *images,
                         bool detailed, int runs, double *ms)
{
    uint32_t push = detailed;
    gpu_step step = {
        .name = "gbuffer",
        .draw = geometry->draw,
        .resources = {view, geometry->positions, geometry->normals, geometry->indices,
                      geometry->materials, geometry->albedos, geometry->faces},
        .push = &push,
        .vertex_count = geometry->corner_count,
        .targets = {images->position, images->normal, images->albedo},
        .depth = images->depth,
    };
    double *times = calloc((size_t)runs, sizeof *times);
    if (!times)
        return gpu_fail(GPU_OUT_OF_MEMORY, "the G-buffer: out of host memory");
    gpu_status status = GPU_OK;
    for (int run = runs > 1 ? -1 : 0; status == GPU_OK && run < runs; run++)
        status = gpu_run(geometry->device, &step, 1, &times[run < 0 ? 0 : run]);
    *ms = 1e3 * base_median(times, (size_t)runs);
    free(times);
    return status;
}
