/* scenes_lobes.c: pictures lit by virtual spherical Gaussian lights, by every method of the
 * registry, as figures 1 and 4 of Tokuyoshi 2022: a sharp light close to a wall, and the light that
 * a scene's spotlight reflects as two broad ones. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/order.h"
#include "base/png.h"
#include "base/progress.h"
#include "base/text.h"
#include "scenes.h"
#include "scenes_lobes.h"
#include "sg.h"

enum { RUNS = 3 };

typedef struct stage {
    const char *figure;
    render_frame frame;
    gpu_buffer *lobes;
    lobe_light lights[LOBE_LIGHTS];
    int light_count;
    float *truth, *light; /* 4 floats a pixel */
    const char *pictures;
} stage;

static size_t pixels_of(const stage *s)
{
    return (size_t)s->frame.width * s->frame.height;
}

static bool failed(const stage *s, const char *what)
{
    base_error("bench: %s, %s: %s", s->figure, what, gpu_last_error());
    return false;
}

static gpu_step pixel_step(const stage *s, gpu_compute *compute, const void *push)
{
    return (gpu_step){
        .name = "lobes",
        .compute = compute,
        .resources = {s->frame.view, s->lobes, s->frame.position, s->frame.normal, s->frame.light},
        .push = push,
        .groups = {(s->frame.width + 15) / 16, (s->frame.height + 7) / 8, 1}};
}

static const gpu_binding bindings[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_FETCHED,
                                       GPU_FETCHED, GPU_STORAGE_IMAGE};

/* ---- The exact picture -------------------------------------------------------------------------
 */

typedef struct row_job {
    const stage *s;
    const lobe_light *light;
    const float *arguments;
    double *scratch; /* 3 a pixel */
} row_job;

static void exact_row(void *context, size_t y)
{
    const row_job *job = context;
    size_t width = job->s->frame.width;
    double *lambda = job->scratch + 3 * y * width, *z = lambda + width, *value = z + width;
    const float *at = job->arguments + 4 * y * width;
    for (size_t x = 0; x < width; x++) {
        bool surface = at[4 * x + 3] > 0.0f;
        lambda[x] = surface ? (double)at[4 * x] : 1.0;
        z[x] = surface ? (double)at[4 * x + 1] : 0.0;
    }
    sg_A_h_cos_batch(width, lambda, z, value);
    float *truth = job->s->truth + 4 * y * width;
    for (size_t x = 0; x < width; x++) {
        if (at[4 * x + 3] <= 0.0f)
            continue;
        for (int c = 0; c < 3; c++)
            truth[4 * x + (size_t)c] +=
                (float)((double)job->light->intensity[c] * (double)at[4 * x + 2] * value[x]);
        truth[4 * x + 3] = 1.0f;
    }
}

static bool make_truth(stage *s)
{
    gpu_compute *compute;
    if (render_compute(&s->frame, "lobes/arguments.comp", false, bindings, 5, sizeof(int),
                       &compute) != GPU_OK)
        return failed(s, "arguments");
    double *scratch = base_allocate(3 * pixels_of(s) * sizeof *scratch + 1);
    memset(s->truth, 0, 4 * pixels_of(s) * sizeof *s->truth);
    bool good = true;
    for (int i = 0; i < s->light_count && good; i++) {
        gpu_step step = pixel_step(s, compute, &i);
        good = (gpu_run(s->frame.device, &step, 1, NULL) == GPU_OK &&
                gpu_image_read(s->frame.light, s->light) == GPU_OK) ||
               failed(s, "arguments");
        row_job job = {s, &s->lights[i], s->light, scratch};
        if (good)
            base_parallel(s->frame.height, exact_row, &job);
    }
    free(scratch);
    gpu_compute_destroy(compute);
    return good;
}

/* ---- A method's picture ------------------------------------------------------------------------
 */

static bool run_method(stage *s, const char *method, double *ms)
{
    gpu_compute *compute;
    s->frame.options.method = method;
    if (render_compute(&s->frame, "lobes/lobes.comp", true, bindings, 5, 0, &compute) != GPU_OK)
        return failed(s, method);
    double times[RUNS];
    bool good = true;
    for (int run = 0; run < RUNS && good; run++) {
        gpu_step step = pixel_step(s, compute, NULL);
        good = gpu_run(s->frame.device, &step, 1, &times[run]) == GPU_OK || failed(s, method);
    }
    gpu_compute_destroy(compute);
    if (!good)
        return false;
    *ms = 1e3 * base_median(times, RUNS);
    return gpu_image_read(s->frame.light, s->light) == GPU_OK || failed(s, method);
}

/* Exposure of all pictures of a figure: the true mean becomes a quarter. */
static float exposure_of(const stage *s)
{
    double sum = 0.0;
    for (size_t i = 0; i < pixels_of(s); i++)
        sum += (double)s->truth[4 * i + 1];
    return sum > 0.0 ? (float)(0.25 * (double)pixels_of(s) / sum) : 1.0f;
}

static bool write_picture(const stage *s, const char *method, const float *pixels)
{
    char name[3 * SCENES_NAME];
    snprintf(name, sizeof name, "%s_%s.png", s->figure, method);
    char *path = base_join(s->pictures, name);
    bool good = png_write_linear(path, (int)s->frame.width, (int)s->frame.height, pixels, 4,
                                 exposure_of(s));
    free(path);
    return good;
}

/* Of those as published, and of the first of ours. */
static bool write_pictures(const stage *s, const char *method, const float *errors)
{
    if (strcmp(sg_method_find(method)->variant, "published") != 0 && strcmp(method, "quick") != 0 &&
        strcmp(method, "standard") != 0)
        return true;
    char name[3 * SCENES_NAME];
    snprintf(name, sizeof name, "%s_%s_smape.png", s->figure, method);
    char *path = base_join(s->pictures, name);
    bool good = scenes_write_errors(path, s->frame.width, s->frame.height, errors, s->truth) &&
                write_picture(s, method, s->light);
    free(path);
    return good;
}

static bool one_method(stage *s, const char *method, double empty, FILE *out)
{
    float *errors = base_allocate(pixels_of(s) * sizeof *errors + 1);
    double ms = 0.0;
    bool good = run_method(s, method, &ms);
    if (good) {
        lobe_outcome o = lobe_compare(s->frame.width, s->frame.height, s->light, s->truth, errors);
        const double numbers[] = {o.smape, o.smape_p99, o.largest, (double)o.black, ms / empty};
        char text[BASE_NUMBER_SIZE];
        fprintf(out, "%s,%s,%s", s->figure, method, sg_method_find(method)->variant);
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
            fprintf(out, ",%s", base_shortest_f64(numbers[i], text));
        fputc('\n', out);
        good = write_pictures(s, method, errors);
    }
    free(errors);
    return good;
}

static bool all_methods(stage *s, FILE *out, base_progress *progress)
{
    double empty = 0.0;
    bool good =
        make_truth(s) && write_picture(s, "exact", s->truth) && run_method(s, "nothing", &empty);
    for (size_t i = 0; i < sg_method_count() && good; i++) {
        good = one_method(s, sg_method_at(i)->id, empty, out);
        base_progress_step(progress, sg_method_at(i)->id);
    }
    return good;
}

static bool one_figure(const scenes_plan *plan, const render_scene *scene, const char *figure,
                       bool sharp, FILE *out, base_progress *progress)
{
    stage s = {.figure = figure, .pictures = plan->out};
    render_options options = {
        .width = plan->quick ? 640 : 3840, .height = plan->quick ? 360 : 2160, .runs = 1};
    if (render_frame_create(plan->device, scene, &options, &s.frame) != GPU_OK)
        return failed(&s, "the frame");
    s.light_count = sharp ? lobe_light_sharp(scene, s.lights) : lobe_lights_of(&s.frame, s.lights);
    s.truth = base_allocate(4 * pixels_of(&s) * sizeof *s.truth + 1);
    s.light = base_allocate(4 * pixels_of(&s) * sizeof *s.light + 1);
    s.pictures = base_join(plan->out, "lobes");
    bool good = base_make_directory(s.pictures);
    if (good && gpu_buffer_create(plan->device, (size_t)s.light_count * sizeof(lobe_light),
                                  &s.lobes) != GPU_OK)
        good = failed(&s, "the lights");
    if (good)
        memcpy(gpu_buffer_map(s.lobes), s.lights, (size_t)s.light_count * sizeof(lobe_light));
    good = good && all_methods(&s, out, progress);
    gpu_buffer_destroy(s.lobes);
    free((char *)s.pictures);
    free(s.truth);
    free(s.light);
    render_frame_destroy(&s.frame);
    return good;
}

static bool both_figures(const scenes_plan *plan, const render_scene *scene, FILE *out)
{
    base_progress *progress = base_progress_begin("lobes", 2 * sg_method_count());
    bool good = one_figure(plan, scene, "sharp", true, out, progress) &&
                one_figure(plan, scene, "reflected", false, out, progress);
    base_progress_end(progress);
    return good;
}

bool scenes_lobes(const scenes_plan *plan)
{
    return scenes_of_box(
        plan, "lobes.csv",
        "figure,method,variant,smape,smape_p99,largest_error,black_pixels,time_ratio\n",
        both_figures);
}
