/* scenes_choice.c: no more than a scene needs: the cheapest method for what a frame integrates, and
 * how much the picture changes by it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/text.h"
#include "choose.h"
#include "render/output.h"
#include "scenes.h"
#include "sg.h"

enum { WIDTH = 640, HEIGHT = 360, PIXELS = WIDTH * HEIGHT };
static const char reference[] = "fine";

typedef struct work {
    const scenes_plan *plan;
    const render_scene *scene;
    const render_pipeline *pipeline;
    float *reference; /* radiance, 4 floats a pixel */
    double gain;
} work;

static bool failed(const work *w, const char *method)
{
    base_error("bench: %s by %s with %s: %s", w->scene->name, w->pipeline->id, method,
               gpu_last_error());
    return false;
}

/* The picture with a method and, where profile is not NULL, what it integrates, as a file. */
static bool render_with(work *w, const char *method, float *radiance, const char *profile)
{
    render_frame frame;
    render_options options = {.width = WIDTH, .height = HEIGHT, .method = method, .runs = 1};
    if (render_frame_create(w->plan->device, w->scene, &options, &frame) != GPU_OK)
        return failed(w, method);
    void *state = NULL;
    render_statistics statistics;
    bool good = w->pipeline->create(&frame, &state) == GPU_OK || failed(w, method);
    bool made = good;
    if (good)
        good = (render_frame_run(&frame, w->pipeline, state, &statistics) == GPU_OK &&
                gpu_image_read(frame.image, radiance) == GPU_OK) ||
               failed(w, method);
    w->gain = frame.gain;
    if (good && profile) {
        float *points;
        size_t count;
        good = w->pipeline->profile(&frame, state, &points, &count) == GPU_OK || failed(w, method);
        if (good) {
            good = output_profile(profile, points, count);
            free(points);
        }
    }
    if (made)
        w->pipeline->destroy(state);
    render_frame_destroy(&frame);
    return good;
}

/* Of the tone-mapped picture, in steps of 1/255. */
static double largest_change(const work *w, const float *radiance)
{
    double largest = 0.0;
    for (size_t i = 0; i < 4 * (size_t)PIXELS; i++)
        if (i % 4 != 3)
            largest = fmax(largest, fabs((double)render_tone(w->gain, radiance[i]) -
                                         (double)render_tone(w->gain, w->reference[i])));
    return 255.0 * largest;
}

/* The cheapest method whose weighted RMSE of L on the profile stays under most; NULL: none. */
static const sg_method *cheapest(const choose_domain *domain, const double *costs, double most,
                                 double *rmse, double *cost)
{
    const sg_method *best = NULL;
    for (size_t i = 0; i < sg_method_count(); i++) {
        choose_error error;
        if (isnan(costs[i]) || (best && costs[i] >= *cost) ||
            !choose_measure(domain, sg_method_at(i), &error) || !(error.rmse <= most))
            continue;
        best = sg_method_at(i);
        *rmse = error.rmse;
        *cost = costs[i];
    }
    return best;
}

static bool choices(work *w, const choose_domain *domain, FILE *out)
{
    static const double most[] = {1e-2, 3e-3, 1e-3, 1e-4, 1e-5};
    double *costs = base_allocate(sg_method_count() * sizeof *costs + 1);
    float *radiance = base_allocate(4 * (size_t)PIXELS * sizeof *radiance);
    bool good = choose_costs(CHOOSE_GPU, NULL, costs);
    const sg_method *last = NULL;
    double change = 0.0; /* of its picture */
    for (size_t i = 0; i < sizeof most / sizeof *most && good; i++) {
        double rmse = 0.0, cost = 0.0;
        const sg_method *method = cheapest(domain, costs, most[i], &rmse, &cost);
        if (!method)
            continue;
        if (method != last) {
            good = render_with(w, method->id, radiance, NULL);
            if (!good)
                break;
            change = largest_change(w, radiance);
            last = method;
        }
        char text[4][BASE_NUMBER_SIZE];
        fprintf(out, "%s,%s,%s,%s,%s,%s,%s\n", w->scene->name, w->pipeline->id,
                base_shortest_f64(most[i], text[0]), method->id, base_shortest_f64(cost, text[1]),
                base_shortest_f64(rmse, text[2]), base_shortest_f64(change, text[3]));
    }
    free(costs);
    free(radiance);
    return good;
}

static bool one_pipeline(const scenes_plan *plan, const render_scene *scene,
                         const render_pipeline *pipeline, FILE *out)
{
    char name[4 * SCENES_NAME];
    snprintf(name, sizeof name, "profile_%s_%s.csv", scene->name, pipeline->id);
    char *path = base_join(plan->out, name);
    work w = {plan, scene, pipeline, base_allocate(4 * (size_t)PIXELS * sizeof(float)), 1.0};
    choose_domain domain;
    bool good = render_with(&w, reference, w.reference, path) && choose_profile(&domain, path);
    if (good) {
        good = choices(&w, &domain, out);
        choose_domain_free(&domain);
    }
    free(w.reference);
    free(path);
    return good;
}

static bool all_pipelines(const scenes_plan *plan, const render_scene *scene, FILE *out)
{
    bool good = true;
    for (size_t i = 0; render_pipelines[i] && good; i++)
        if (render_pipelines[i]->profile)
            good = one_pipeline(plan, scene, render_pipelines[i], out);
    return good;
}

bool scenes_choice(const scenes_plan *plan)
{
    return scenes_of_box(plan, "choice.csv",
                         "scene,pipeline,max_rmse,method,instructions,rmse,largest_change_of_255\n",
                         all_pipelines);
}
