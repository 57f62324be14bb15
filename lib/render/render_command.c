/* sgfit render: a scene by one pipeline, its pictures and its numbers. */
#include "render_command.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/json.h"
#include "base/options.h"
#include "base/text.h"
#include "lpv.h"
#include "output.h"
#include "sg.h"

typedef struct settings {
    const char *scene, *scene_dir, *pipeline, *size, *compare, *method, *device;
    const char *out, *png, *stats, *dump, *profile, *indirect;
    bool layers, detailed;
    long runs, volume, steps;
} settings;

#define DIGITS_OF(NUMBER) #NUMBER
#define DIGITS(MACRO)     DIGITS_OF(MACRO)

enum { LARGEST_SIDE = 16384, MOST_RUNS = 1000 };
static const long not_given = LONG_MIN;

/* ---- Arguments ----------------------------------------------------------------------- */

/* WIDTHxHEIGHT, both from 1 to LARGEST_SIDE. */
static bool read_size(const char *text, render_options *options)
{
    const char *x = strchr(text, 'x');
    long width = 0, height = 0;
    char first[8] = "";
    if (x && x - text < (long)sizeof first) {
        memcpy(first, text, (size_t)(x - text));
        if (base_parse_long(first, &width) && base_parse_long(x + 1, &height) && width >= 1 &&
            width <= LARGEST_SIDE && height >= 1 && height <= LARGEST_SIDE) {
            options->width = (uint32_t)width;
            options->height = (uint32_t)height;
            return true;
        }
    }
    base_error("--size: expected WIDTHxHEIGHT, each from 1 to %d, found \"%s\"", LARGEST_SIDE,
               text);
    return false;
}

static bool read_indirect(const settings *s, render_options *options)
{
    bool lpv = s->indirect && strcmp(s->indirect, "lpv") == 0;
    const long values[] = {s->volume, s->steps}, most[] = {LPV_MOST_VOLUME, LPV_MOST_STEPS};
    static const char *const names[] = {"volume", "steps"};
    for (int i = 0; i < 2; i++) {
        if (values[i] == not_given)
            continue;
        if (values[i] < 1 || values[i] > most[i]) {
            base_error("--%s: expected a number from 1 to %ld, found %ld", names[i], most[i],
                       values[i]);
            return false;
        }
        if (!lpv) {
            base_error("--%s: expected --indirect lpv, whose volume it is about", names[i]);
            return false;
        }
    }
    options->indirect = lpv ? RENDER_INDIRECT_LPV : RENDER_INDIRECT_NONE;
    options->volume = s->volume == not_given ? 0 : (uint32_t)s->volume;
    options->steps = s->steps == not_given ? 0 : (uint32_t)s->steps;
    return true;
}

static int read_arguments(int argc, char **argv, settings *s)
{
    const base_option options[] = {
        {"scene", BASE_STRING, &s->scene, "FILE.json",
         "description of the scene (default: the built-in box)", NULL},
        {"scene-dir", BASE_STRING, &s->scene_dir, "DIR",
         "where meshes are that are not beside the description (default: $SGFIT_SCENES)", NULL},
        {"pipeline", BASE_STRING, &s->pipeline, "ID",
         "how to light it, as listed above (default: hull)", NULL},
        {"size", BASE_STRING, &s->size, "WxH", "pixels (default: 1280x720)", NULL},
        {"compare", BASE_CHOICE, &s->compare, "exact|shadows",
         "compare with ground truth: of all lights without shadows, or of area lights with them",
         NULL},
        {"method", BASE_STRING, &s->method, "ID",
         "integrate lobes by this method of the registry, where the pipeline has any (default: "
         "standard)",
         NULL},
        {"detailed-normals", BASE_FLAG, &s->detailed, NULL,
         "add strong procedural bumps to the shading normals", NULL},
        {"indirect", BASE_CHOICE, &s->indirect, "none|lpv",
         "add one diffuse bounce, by a light propagation volume (default: none)", NULL},
        {"volume", BASE_LONG, &s->volume, "N",
         "voxels along the volume's longest side (default: " DIGITS(LPV_USUAL_VOLUME) ")", NULL},
        {"steps", BASE_LONG, &s->steps, "N",
         "how often light moves on in the volume (default: 2 N)", NULL},
        {"runs", BASE_LONG, &s->runs, "N",
         "times are medians of N runs after one that does not count (default: 1, which counts with "
         "the driver's compiling)",
         NULL},
        {"out", BASE_STRING, &s->out, "FILE.exr", "write linear radiance", NULL},
        {"layers", BASE_FLAG, &s->layers, NULL,
         "also the G-buffer, the light buffer and the truth, as channels of that file", NULL},
        {"png", BASE_STRING, &s->png, "FILE.png", "write a tone-mapped picture", NULL},
        {"stats", BASE_STRING, &s->stats, "FILE.json",
         "write the statistics there, not to standard output", NULL},
        {"dump", BASE_STRING, &s->dump, "DIR", "write a picture of every stage", NULL},
        {"profile", BASE_STRING, &s->profile, "FILE.csv",
         "write what the frame integrates, for sgfit choose and sgfit fit", NULL},
        {"device", BASE_STRING, &s->device, "NAME",
         "part of the Vulkan device's name (default: llvmpipe, the software driver)", NULL},
    };
    char *text = render_pipelines_help(
        "Renders a scene by one pipeline on a Vulkan device, counts what that took, and compares "
        "it with ground truth. Pictures are tone-mapped by Reinhard's curve, x (1 + x/16)/(1 + x), "
        "with an exposure that depends on the scene and the view alone.");
    const base_usage usage = {"render", "[options]", text};
    int status =
        base_parse_options(argc, argv, &usage, options, sizeof options / sizeof *options, NULL);
    free(text);
    return status;
}

/* ---- Rendering ----------------------------------------------------------------------- */

static bool is_good(gpu_status status)
{
    if (status != GPU_OK)
        base_error("%s", gpu_last_error());
    return status == GPU_OK;
}

/* The truth of the same frame, its times and the comparison. */
static bool compare(render_frame *frame, const char *id, output_frame *out, cJSON *json)
{
    const render_pipeline *truth = render_pipeline_find(id);
    render_statistics statistics;
    if (!is_good(render_frame_light(frame, truth, &statistics)) ||
        !is_good(output_read_image(frame->light, &out->truth)))
        return false;
    size_t pixels = (size_t)out->width * (size_t)out->height;
    out->errors = base_allocate(pixels * sizeof *out->errors);
    render_comparison comparison;
    render_compare(pixels, out->light, out->truth, out->errors, &comparison);
    output_comparison(json, &comparison);
    base_json_add_f64(
        json, "ssim",
        render_ssim(frame->width, frame->height, frame->gain, out->light, out->truth));
    for (int i = 0; i < statistics.time_count; i++)
        if (strcmp(statistics.times[i].name, id) == 0)
            base_json_add_f64(json, "ground_truth_ms", statistics.times[i].ms);
    return true;
}

static void describe(const settings *s, const render_frame *frame, const render_pipeline *pipeline,
                     cJSON *json)
{
    const gpu_device_info *info = gpu_device_about(frame->device);
    cJSON_AddStringToObject(json, "scene", frame->scene->name);
    cJSON_AddStringToObject(json, "pipeline", pipeline->id);
    cJSON_AddStringToObject(json, "method", s->method ? s->method : "standard");
    cJSON *size = cJSON_AddArrayToObject(json, "size");
    cJSON_AddItemToArray(size, base_json_number(frame->width));
    cJSON_AddItemToArray(size, base_json_number(frame->height));
    cJSON_AddBoolToObject(json, "detailed_normals", s->detailed);
    base_json_add_f64(json, "runs", (double)s->runs);
    cJSON_AddStringToObject(json, "device", info->name);
    cJSON_AddStringToObject(json, "driver", info->version);
    base_json_add_f64(json, "gain", frame->gain);
    base_json_add_f64(json, "dropped_triangles", (double)frame->scene->dropped_triangles);
    output_origin(json, frame->scene);
}

static bool write_all(const settings *s, const output_frame *out, double gain, const cJSON *json)
{
    return (!s->out || output_exr(s->out, out)) &&
           (!s->png || output_png(s->png, out->width, out->height, out->radiance, gain)) &&
           (!s->dump || output_dump(s->dump, out, gain)) && output_json(s->stats, json);
}

/* A frame by the pipeline, and what only that can tell of it. */
static bool light(const settings *s, render_frame *frame, const render_pipeline *pipeline,
                  render_statistics *statistics)
{
    void *state = NULL;
    if (!is_good(pipeline->create(frame, &state)))
        return false;
    bool good = is_good(render_frame_run(frame, pipeline, state, statistics));
    if (good && s->dump && pipeline->dump)
        good = pipeline->dump(frame, state, s->dump);
    if (good && s->profile) {
        float *points = NULL;
        size_t count = 0;
        good = is_good(pipeline->profile(frame, state, &points, &count)) &&
               output_profile(s->profile, points, count);
        free(points);
    }
    pipeline->destroy(state);
    return good;
}

static bool light_and_write(const settings *s, render_frame *frame, const render_pipeline *pipeline)
{
    cJSON *json = cJSON_CreateObject();
    output_frame out = {0};
    render_statistics statistics;
    describe(s, frame, pipeline, json);
    bool good = light(s, frame, pipeline, &statistics) &&
                is_good(output_read(frame, s->layers || s->dump, &out));
    if (good) {
        output_statistics(json, &statistics);
        good = !s->compare || compare(frame, s->compare, &out, json);
    }
    good = good && write_all(s, &out, frame->gain, json);
    output_free(&out);
    cJSON_Delete(json);
    return good;
}

static bool render(const settings *s, const render_options *options,
                   const render_pipeline *pipeline, const render_scene *scene)
{
    gpu_device *device;
    gpu_device_options choice = {.device = s->device};
    if (!is_good(gpu_device_open(&choice, &device)))
        return false;
    render_frame frame;
    bool good = is_good(render_frame_create(device, scene, options, &frame));
    if (good) {
        good = (!s->dump || base_make_directory(s->dump)) && light_and_write(s, &frame, pipeline);
        render_frame_destroy(&frame);
    }
    gpu_device_close(device);
    return good;
}

/* Before the work, as the truth's own pipeline would refuse it after that. */
static bool has_truth(const settings *s, const render_scene *scene)
{
    bool shadows = s->compare && render_pipeline_find(s->compare)->shadows;
    if (shadows && scene->area_light_count == 0)
        base_error("--compare shadows: shadows are those of area lights, and \"%s\" has none",
                   scene->name);
    return !shadows || scene->area_light_count > 0;
}

int render_command(int argc, char **argv)
{
    settings s = {.pipeline = "hull",
                  .size = "1280x720",
                  .runs = 1,
                  .volume = not_given,
                  .steps = not_given,
                  .device = "llvmpipe"};
    int status = read_arguments(argc, argv, &s);
    if (status >= 0)
        return status;
    render_options options = {
        .method = s.method, .detailed_normals = s.detailed, .runs = (int)s.runs};
    const render_pipeline *pipeline = render_pipeline_choose(s.pipeline);
    const char *const paths[OUTPUT_PATHS] = {s.out, s.png, s.stats, s.profile, s.dump};
    if (!pipeline || !read_size(s.size, &options) || !read_indirect(&s, &options) ||
        !output_are_apart(paths))
        return BASE_USAGE;
    if (s.runs < 1 || s.runs > MOST_RUNS) {
        base_error("--runs: expected a number from 1 to %d, found %ld", MOST_RUNS, s.runs);
        return BASE_USAGE;
    }
    if (s.method && !sg_method_find(s.method)) {
        base_error("--method: expected one that sgfit methods lists, found \"%s\"", s.method);
        return BASE_USAGE;
    }
    if (s.profile && !pipeline->profile) {
        base_error("--profile: expected a pipeline that integrates lobes, %s does not",
                   pipeline->id);
        return BASE_USAGE;
    }
    if (s.layers && !s.out) {
        base_error("--layers: expected --out, into which the layers are written");
        return BASE_USAGE;
    }
    if (!output_can_be_written(paths))
        return BASE_FAILED;
    char *standard = s.scene ? NULL : render_scene_default();
    render_scene scene;
    bool read = render_scene_read(s.scene ? s.scene : standard, s.scene_dir, &scene);
    free(standard);
    if (!read)
        return BASE_USAGE;
    bool good = has_truth(&s, &scene) && render(&s, &options, pipeline, &scene);
    render_scene_free(&scene);
    return good ? BASE_DONE : BASE_FAILED;
}
