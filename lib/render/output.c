/* Reading a frame back and writing it as EXR, and its numbers as JSON. */
#include "output.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/buffer.h"
#include "base/exr.h"
#include "base/file.h"
#include "base/json.h"
#include "base/text.h"
#include "internal.h"

bool output_are_apart(const char *const paths[OUTPUT_PATHS])
{
    static const char *const names[OUTPUT_PATHS] = {"out", "png", "stats", "profile", "dump"};
    for (int i = 0; i < OUTPUT_PATHS; i++)
        for (int j = 0; j < i; j++)
            if (paths[i] && paths[j] && base_same_file(paths[j], paths[i])) {
                base_error("--%s: expected a %s of its own, found that of --%s: %s", names[i],
                           i == OUTPUT_DUMP ? "folder" : "file", names[j], paths[i]);
                return false;
            }
    return true;
}

/* Whether the file stands directly in the folder, by name: the folder may not be there yet. */
static bool is_in(const char *folder, const char *file)
{
    const char *slash = strrchr(file, '/');
    size_t length = strlen(folder);
    while (length > 1 && folder[length - 1] == '/')
        length--;
    return slash && (size_t)(slash - file) == length && strncmp(file, folder, length) == 0;
}

bool output_can_be_written(const char *const paths[OUTPUT_PATHS])
{
    const char *dump = paths[OUTPUT_DUMP];
    struct stat status;
    bool good = !dump || base_can_fill(dump), made = dump && stat(dump, &status) != 0;
    for (int i = 0; good && i < OUTPUT_DUMP; i++)
        good = !paths[i] || (made && is_in(dump, paths[i])) || base_can_write(paths[i]);
    return good;
}

/* ---- Reading ------------------------------------------------------------------------- */

static size_t pixels_of(gpu_image *image)
{
    return (size_t)gpu_image_width(image) * gpu_image_height(image);
}

gpu_status output_read_image(gpu_image *image, float **pixels)
{
    *pixels = base_allocate(pixels_of(image) * 4 * sizeof **pixels);
    return gpu_image_read(image, *pixels);
}

static gpu_status read_normals(gpu_image *image, output_frame *out)
{
    size_t pixels = pixels_of(image);
    uint32_t *packed = base_allocate(pixels * 2 * sizeof *packed);
    gpu_status status = gpu_image_read(image, packed);
    out->shading = base_allocate(pixels * 3 * sizeof(float));
    out->geometric = base_allocate(pixels * 3 * sizeof(float));
    for (size_t i = 0; status == GPU_OK && i < pixels; i++) {
        bool surface = out->position[4 * i + 3] > 0;
        unpack_normal(packed[2 * i], out->shading + 3 * i);
        unpack_normal(packed[2 * i + 1], out->geometric + 3 * i);
        for (size_t c = 0; !surface && c < 3; c++)
            out->shading[3 * i + c] = out->geometric[3 * i + c] = 0;
    }
    free(packed);
    return status;
}

static gpu_status read_albedo(gpu_image *image, output_frame *out)
{
    size_t pixels = pixels_of(image);
    uint8_t *bytes = base_allocate(pixels * 4);
    gpu_status status = gpu_image_read(image, bytes);
    out->albedo = base_allocate(pixels * 4 * sizeof(float));
    for (size_t i = 0; status == GPU_OK && i < 4 * pixels; i++)
        out->albedo[i] = (float)bytes[i] / 255;
    free(bytes);
    return status;
}

gpu_status output_read(render_frame *frame, bool layers, output_frame *out)
{
    *out = (output_frame){.width = (int)frame->width, .height = (int)frame->height};
    memcpy(out->origin, frame->scene->origin, sizeof out->origin);
    gpu_status status = output_read_image(frame->image, &out->radiance);
    if (status == GPU_OK)
        status = output_read_image(frame->light, &out->light);
    if (status == GPU_OK && layers)
        status = output_read_image(frame->position, &out->position);
    if (status == GPU_OK && layers)
        status = read_normals(frame->normal, out);
    if (status == GPU_OK && layers)
        status = read_albedo(frame->albedo, out);
    return status;
}

void output_free(output_frame *out)
{
    free(out->radiance);
    free(out->light);
    free(out->truth);
    free(out->errors);
    free(out->position);
    free(out->shading);
    free(out->geometric);
    free(out->albedo);
    *out = (output_frame){0};
}

/* ---- EXR ----------------------------------------------------------------------------- */

enum { MOST_CHANNELS = 32 };

typedef struct channels {
    exr_channel list[MOST_CHANNELS];
    char names[MOST_CHANNELS][32];
    size_t count;
} channels;

/* One channel for each letter; layer "": without a point before it. Without pixels nothing. */
static void add(channels *to, const char *layer, const char *letters, const float *pixels,
                int stride)
{
    for (int i = 0; pixels && letters[i]; i++) {
        char *name = to->names[to->count];
        size_t length = strlen(layer);
        memcpy(name, layer, length);
        if (length)
            name[length++] = '.';
        name[length] = letters[i];
        name[length + 1] = 0;
        to->list[to->count++] = (exr_channel){.name = name, .pixels = pixels + i, .stride = stride};
    }
}

/* "x y z"; false where the positions are the description's. */
static bool write_origin(const output_frame *out, char text[3 * BASE_NUMBER_SIZE + 2])
{
    bool moved = false;
    text[0] = '\0';
    for (int i = 0; i < 3; i++) {
        char number[BASE_NUMBER_SIZE];
        strcat(strcat(text, i ? " " : ""), base_shortest_f64(out->origin[i], number));
        moved = moved || out->origin[i] != 0;
    }
    return moved;
}

bool output_exr(const char *path, const output_frame *out)
{
    channels all = {.count = 0};
    add(&all, "", "RGB", out->radiance, 4);
    if (out->position) {
        add(&all, "position", "XYZ", out->position, 4);
        add(&all, "depth", "Z", out->position + 3, 4);
        add(&all, "normal", "XYZ", out->shading, 3);
        add(&all, "geometric_normal", "XYZ", out->geometric, 3);
        add(&all, "albedo", "RGB", out->albedo, 4);
        add(&all, "irradiance", "RGB", out->light, 4);
        add(&all, "state", "Y", out->light + 3, 4);
        add(&all, "truth", "RGB", out->truth, 4);
        add(&all, "error", "Y", out->errors, 1);
    }
    char origin[3 * BASE_NUMBER_SIZE + 2];
    bool moved = write_origin(out, origin);
    const exr_text attribute = {"origin", origin};
    exr_image image = {.width = out->width,
                       .height = out->height,
                       .channels = all.list,
                       .channel_count = all.count,
                       .compressed = true,
                       .attributes = &attribute,
                       .attribute_count = moved && out->position ? 1 : 0};
    return exr_write(path, &image);
}

/* ---- Numbers ------------------------------------------------------------------------- */

static void add_count(cJSON *object, const char *key, uint64_t count)
{
    base_json_add_f64(object, key, (double)count);
}

void output_origin(cJSON *object, const render_scene *scene)
{
    cJSON *origin = cJSON_AddArrayToObject(object, "origin");
    for (int i = 0; i < 3; i++)
        cJSON_AddItemToArray(origin, base_json_number(scene->origin[i]));
}

static void output_fragments(cJSON *object, const render_statistics *statistics)
{
    uint64_t sum = 0;
    cJSON *levels = cJSON_CreateArray();
    for (int i = 0; i < RENDER_LEVELS; i++) {
        sum += statistics->fragments_by_level[i];
        cJSON_AddItemToArray(levels, base_json_number((double)statistics->fragments_by_level[i]));
    }
    add_count(object, "fragments", sum);
    cJSON_AddItemToObject(object, "fragments_by_level", levels);
    add_count(object, "visibility_rays", statistics->visibility_rays);
    add_count(object, "samples", statistics->samples);
}

void output_statistics(cJSON *object, const render_statistics *statistics)
{
    add_count(object, "triangles", statistics->triangles);
    add_count(object, "lights", statistics->lights);
    add_count(object, "pixels_covered", statistics->pixels_covered);
    add_count(object, "pixels_uncovered", statistics->pixels_uncovered);
    add_count(object, "pixels_wrong", statistics->pixels_wrong);
    add_count(object, "quads", statistics->quads);
    add_count(object, "vertices", statistics->vertices);
    add_count(object, "light_evaluations", statistics->light_evaluations);
    add_count(object, "ground_truth_evaluations", statistics->ground_truth_evaluations);
    if (statistics->visibility_rays || statistics->samples)
        output_fragments(object, statistics);
    if (statistics->voxels) {
        add_count(object, "volume_samples", statistics->volume_samples);
        add_count(object, "voxels", statistics->voxels);
    }
    cJSON *times = cJSON_AddObjectToObject(object, "times_ms");
    double all = 0, lighting = 0;
    for (int i = 0; i < statistics->time_count; i++) {
        const char *name = statistics->times[i].name;
        double ms = statistics->times[i].ms;
        base_json_add_f64(times, name, ms);
        bool shared = strcmp(name, "gbuffer") == 0 || strcmp(name, "rsm") == 0 ||
                      strcmp(name, "resolve") == 0;
        all += ms;
        lighting += shared ? 0 : ms;
    }
    base_json_add_f64(object, "frame_ms", all);
    base_json_add_f64(object, "lighting_ms", lighting);
}

void output_comparison(cJSON *object, const render_comparison *comparison)
{
    base_json_add_f64(object, "rel", comparison->rel);
    base_json_add_f64(object, "p50", comparison->p50);
    base_json_add_f64(object, "p95", comparison->p95);
    base_json_add_f64(object, "p99", comparison->p99);
    base_json_add_f64(object, "p999", comparison->p999);
    base_json_add_f64(object, "bias", comparison->bias);
}

bool output_json(const char *path, const cJSON *json)
{
    char *text = base_json_print(json);
    bool good = !path || base_write_file(path, text, strlen(text));
    if (!path)
        fputs(text, stdout);
    free(text);
    return good;
}
