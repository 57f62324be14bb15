/* scenes_indirect.c: one bounce by the light propagation volume against paths that Embree traces:
 * error, time and share of the frame over the volume's size and steps, and pictures. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "render/bounce.h"
#include "render/lpv.h"
#include "render/output.h"
#include "scenes.h"

typedef struct setting {
    uint32_t volume, steps;
    bool printed;
} setting;

/* The default first: of its light there are pictures. */
static const setting settings[] = {
    {0, 0, false},   {8, 16, false},  {16, 16, false}, {16, 32, false},  {32, 16, false},
    {32, 32, false}, {32, 64, false}, {64, 64, false}, {64, 128, false}, {0, 0, true}};
static const setting quick_settings[] = {
    {0, 0, false}, {8, 16, false}, {32, 64, false}, {0, 0, true}};

typedef struct view {
    const scenes_plan *plan;
    const char *pictures, *name;
    FILE *out;
    render_frame frame;
    uint32_t step; /* of the reference's places */
    bounce reference;
    double direct_ms, shared_ms; /* of multires and of what every pipeline needs */
    float *light;                /* of the frame: indirect alone */
} view;

static bool failed(const view *v)
{
    base_error("%s, indirect light: %s", v->name, gpu_last_error());
    return false;
}

/* A row that the device cannot do is told in a line; false where no other will be done either. */
static bool left_out(const view *v, gpu_status status)
{
    failed(v);
    return status != GPU_DEVICE_LOST && status != GPU_NO_DEVICE;
}

static double sum_of(const render_statistics *s, bool lpv)
{
    double sum = 0;
    for (int i = 0; i < s->time_count; i++)
        sum += (strncmp(s->times[i].name, "lpv ", 4) == 0) == lpv ? s->times[i].ms : 0;
    return sum;
}

/* ---- Pictures ------------------------------------------------------------------------- */

static bool picture(const view *v, const char *what, uint32_t width, uint32_t height,
                    const float *pixels, double gain)
{
    char name[128];
    snprintf(name, sizeof name, "%s_%s.png", v->name, what);
    char *path = base_join(v->pictures, name);
    bool good = output_png(path, (int)width, (int)height, pixels, gain);
    free(path);
    return good;
}

/* Direct and indirect irradiance with one exposure, the reference and the error in its places. */
static bool pictures(view *v, const float *direct, double mean)
{
    uint32_t width = v->frame.width, height = v->frame.height;
    const bounce *r = &v->reference;
    size_t places = (size_t)r->width * r->height;
    float *errors = base_allocate(places * sizeof *errors);
    double gain = mean > 0 ? 0.4 / mean : 1;
    for (size_t i = 0; i < 4 * (size_t)width * height; i++)
        v->light[i] = direct[i / 4 * 4 + 3] != 0 ? v->light[i] : 0; /* no surface */
    for (uint32_t y = 0; y < r->height; y++)
        for (uint32_t x = 0; x < r->width; x++) {
            size_t at = (size_t)y * r->width + x;
            size_t pixel = (size_t)(y * v->step + v->step / 2) * width + x * v->step + v->step / 2;
            double square = 0;
            for (size_t k = 0; k < 3; k++) {
                double off = (double)v->light[4 * pixel + k] - (double)r->irradiance[4 * at + k];
                square += off * off / 3;
            }
            errors[at] = mean > 0 ? (float)(sqrt(square) / mean / 4) : 0;
        }
    char name[128];
    snprintf(name, sizeof name, "%s_error.png", v->name);
    char *path = base_join(v->pictures, name);
    bool good = picture(v, "direct", width, height, direct, gain) &&
                picture(v, "indirect", width, height, v->light, gain) &&
                picture(v, "reference", r->width, r->height, r->irradiance, gain) &&
                scenes_write_errors(path, r->width, r->height, errors, r->irradiance);
    free(path);
    free(errors);
    return good;
}

/* ---- One setting ---------------------------------------------------------------------- */

/* Indirect light alone, of a frame whose light is 0. */
static gpu_status light_with(view *v, lpv *l, render_statistics *statistics)
{
    gpu_step clear = {.name = "clear", .clear = v->frame.light, .clear_value = {0, 0, 0, 1}};
    gpu_status status = gpu_run(v->frame.device, &clear, 1, NULL);
    if (status == GPU_OK)
        status = lpv_run(&v->frame, l, false, statistics);
    if (status == GPU_OK)
        status = gpu_image_read(v->frame.light, v->light);
    return status;
}

static void write_row(const view *v, const lpv *l, const render_statistics *statistics,
                      const bounce_comparison *c)
{
    double ms = sum_of(statistics, true);
    const double numbers[] = {c->rel, c->noise, c->bias, ms,
                              100 * ms / (ms + v->direct_ms + v->shared_ms)};
    fprintf(v->out, "%s,%u,%u,%s,%u,%u,%u,%u", v->name, v->frame.width, v->frame.height,
            l->settings.printed ? "as printed" : "ours", l->settings.volume, l->settings.steps,
            l->samples, l->push.voxels);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        char text[BASE_NUMBER_SIZE];
        fprintf(v->out, ",%s", base_shortest_f64(numbers[i], text));
    }
    fputc('\n', v->out);
}

static bool one_setting(view *v, const setting *s, const float *direct)
{
    lpv_settings chosen = lpv_default;
    chosen.volume = s->volume ? s->volume : chosen.volume;
    chosen.steps = s->steps ? s->steps : chosen.steps;
    chosen.printed = s->printed;
    lpv *l;
    gpu_status status = lpv_create(&v->frame, &chosen, &l);
    if (status != GPU_OK)
        return left_out(v, status);
    render_statistics statistics = {.time_count = 0};
    status = light_with(v, l, &statistics);
    bool good = status == GPU_OK || left_out(v, status);
    if (status == GPU_OK) {
        bounce_comparison c;
        bounce_compare(&v->reference, v->light, v->frame.width, v->step, &c);
        write_row(v, l, &statistics, &c);
        if (direct)
            good = pictures(v, direct, c.mean);
    }
    lpv_destroy(l);
    return good;
}

/* ---- One scene ------------------------------------------------------------------------ */

/* The frame by multires, its times and its light. */
static bool light_directly(view *v, float *direct)
{
    render_statistics statistics;
    if (render_frame_light(&v->frame, render_pipeline_find("multires"), &statistics) != GPU_OK ||
        gpu_image_read(v->frame.light, direct) != GPU_OK)
        return failed(v);
    static const char *const shared[] = {"gbuffer", "rsm", "resolve"};
    v->shared_ms = 0;
    for (int i = 0; i < statistics.time_count; i++)
        for (size_t n = 0; n < sizeof shared / sizeof *shared; n++)
            v->shared_ms +=
                strcmp(statistics.times[i].name, shared[n]) == 0 ? statistics.times[i].ms : 0;
    v->direct_ms = sum_of(&statistics, false) - v->shared_ms;
    return true;
}

static bool all_settings(view *v, base_progress *progress)
{
    bool quick = v->plan->quick;
    const setting *list = quick ? quick_settings : settings;
    size_t count =
        quick ? sizeof quick_settings / sizeof *quick_settings : sizeof settings / sizeof *settings;
    size_t pixels = (size_t)v->frame.width * v->frame.height;
    float *direct = base_allocate(pixels * 16);
    v->light = base_allocate(pixels * 16);
    bounce_options options = {.paths = quick ? 64 : 256, .step = v->step};
    bool good = true, lit = light_directly(v, direct) &&
                            (bounce_render(&v->frame, &options, &v->reference) == GPU_OK ||
                             failed(v));   /* else told, and the scene left out */
    v->frame.options.runs = quick ? 2 : 3; /* after one that does not count */
    for (size_t i = 0; i < count && good && lit; i++) {
        good = one_setting(v, &list[i], i == 0 ? direct : NULL);
        base_progress_step(progress, v->name);
    }
    bounce_free(&v->reference);
    free(direct);
    free(v->light);
    return good;
}

static bool one_scene(const scenes_plan *plan, const char *path, const char *folder, FILE *out,
                      base_progress *progress)
{
    render_scene scene;
    if (!render_scene_read(path, plan->folder, &scene))
        return false;
    view v = {.plan = plan, .pictures = folder, .name = scene.name, .out = out};
    v.step = 4;
    render_options options = {
        .width = plan->quick ? 512 : 1024, .height = plan->quick ? 384 : 768, .runs = 1};
    bool good =
        render_frame_create(plan->device, &scene, &options, &v.frame) == GPU_OK || failed(&v);
    if (good) {
        good = all_settings(&v, progress);
        render_frame_destroy(&v.frame);
    }
    render_scene_free(&scene);
    return good;
}

bool scenes_indirect(const scenes_plan *plan)
{
    char **paths;
    size_t count;
    if (!scenes_list(plan, true, &paths, &count))
        return false;
    size_t used = plan->quick && count > 1 ? 1 : count;
    char *folder = base_join(plan->out, "indirect"), *csv = base_join(plan->out, "indirect.csv");
    base_output output;
    bool good = base_make_directory(folder) && base_output_open(&output, csv);
    if (good) {
        size_t each = plan->quick ? sizeof quick_settings / sizeof *quick_settings
                                  : sizeof settings / sizeof *settings;
        base_progress *progress = base_progress_begin("indirect light", used * each);
        fputs("scene,width,height,propagation,volume,steps,volume_samples,voxels,rel,"
              "reference_noise,bias,ms,frame_percent\n",
              output.stream);
        for (size_t i = 0; i < used && good; i++)
            good = one_scene(plan, paths[i], folder, output.stream, progress);
        base_progress_end(progress);
        if (good)
            good = base_output_close(&output);
        else
            base_output_discard(&output);
    }
    free(folder);
    free(csv);
    base_list_free(paths, count);
    return good;
}
