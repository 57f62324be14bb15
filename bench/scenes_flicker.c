/* scenes_flicker.c: a moving camera and a moving light: how much of the change in time is the
 * pipeline's own. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/progress.h"
#include "base/text.h"
#include "scenes.h"

enum { WIDTH = 480, HEIGHT = 270, PIXELS = WIDTH * HEIGHT, FRAMES = 60, QUICK_FRAMES = 6 };
static const char *const pipelines[] = {"meder",        "hull",         "hull_lobe",
                                        "upsample2",    "upsample4",    "upsample8",
                                        "upsample_sh8", "upsample_far", NULL};
enum { PIPELINES = sizeof pipelines / sizeof *pipelines }; /* with `exact` */

/* The last three frames of one pipeline, and its sums over pixels and frames. */
typedef struct history {
    float *light[3]; /* 4 floats a pixel */
    double own, all,
        truth; /* sums of squared second differences: of the error, of E, of the truth */
} history;

typedef struct film {
    history of[PIPELINES];
    int frame;
    size_t at;   /* pipeline that comes next */
    double mean; /* of the truth in this frame */
} film;

static double mean_of(const float *truth)
{
    double sum = 0.0, count = 0.0;
    for (size_t i = 0; i < PIXELS; i++)
        if (truth[4 * i + 3] != 0.0f) {
            sum += (double)truth[4 * i] + (double)truth[4 * i + 1] + (double)truth[4 * i + 2];
            count += 3.0;
        }
    return count > 0.0 ? sum / count : 1.0;
}

static double second_difference(float *const frames[3], size_t i)
{
    return (double)frames[0][i] - 2.0 * (double)frames[1][i] + (double)frames[2][i];
}

/* Over pixels that show a surface in all three frames. */
static void accumulate(history *h, const history *truth, double mean)
{
    for (size_t p = 0; p < PIXELS; p++) {
        bool there = true;
        for (int t = 0; t < 3; t++)
            there = there && truth->light[t][4 * p + 3] != 0.0f;
        for (size_t c = 0; c < 3 && there; c++) {
            double all = second_difference(h->light, 4 * p + c) / mean,
                   real = second_difference(truth->light, 4 * p + c) / mean;
            h->own += (all - real) * (all - real) / (3.0 * PIXELS);
            h->all += all * all / (3.0 * PIXELS);
            h->truth += real * real / (3.0 * PIXELS);
        }
    }
}

static bool look(void *context, render_frame *frame, const scenes_row *row, const float *light,
                 const float *truth, const float *errors)
{
    film *f = context;
    (void)frame;
    (void)row;
    (void)errors;
    history *h = &f->of[f->at];
    float *oldest = h->light[0];
    h->light[0] = h->light[1];
    h->light[1] = h->light[2];
    h->light[2] = oldest;
    memcpy(oldest, light, (size_t)PIXELS * 4 * sizeof *oldest);
    if (f->at == 0)
        f->mean = mean_of(truth);
    if (f->frame >= 2)
        accumulate(h, &f->of[0], f->mean);
    f->at++;
    return true;
}

/* The eye swings around its target by 6 degrees there and back; the light's target moves by a tenth
 * of the scene's size. */
static void pose(render_scene *scene, const render_scene *base, int frame, int frames, bool light)
{
    double t = sin(2.0 * 3.14159265358979323846 * frame / (double)frames);
    scene->camera = base->camera;
    scene->spot = base->spot;
    if (light) {
        scene->spot.target[0] = base->spot.target[0] + 0.1 * t * (base->high[0] - base->low[0]);
        return;
    }
    double angle = t * 6.0 * 3.14159265358979323846 / 180.0,
           x = base->camera.eye[0] - base->camera.target[0],
           z = base->camera.eye[2] - base->camera.target[2];
    scene->camera.eye[0] = base->camera.target[0] + x * cos(angle) - z * sin(angle);
    scene->camera.eye[2] = base->camera.target[2] + x * sin(angle) + z * cos(angle);
}

static void write_film(FILE *out, const char *what, const film *f, const scenes_table *names)
{
    for (size_t i = 0; i < names->count; i++) {
        const history *h = &f->of[i];
        double frames = f->frame > 2 ? f->frame - 2 : 1;
        char own[BASE_NUMBER_SIZE], ratio[BASE_NUMBER_SIZE];
        fprintf(out, "%s,%s,%s,%s\n", what, names->rows[i].pipeline,
                base_shortest_f64(sqrt(h->own / frames), own),
                base_shortest_f64(h->truth > 0.0 ? sqrt(h->all / h->truth) : 1.0, ratio));
    }
}

static bool shoot(const scenes_plan *plan, const render_scene *base, bool light, FILE *out,
                  base_progress *progress)
{
    film f = {.frame = 0};
    for (size_t i = 0; i < PIPELINES; i++)
        for (int t = 0; t < 3; t++)
            f.of[i].light[t] = base_allocate((size_t)PIXELS * 4 * sizeof(float));
    int frames = plan->quick ? QUICK_FRAMES : FRAMES;
    render_scene scene = *base;
    scenes_table table = {0};
    bool good = true;
    for (f.frame = 0; f.frame < frames && good; f.frame++) {
        pose(&scene, base, f.frame, frames, light);
        f.at = 0;
        scenes_table_free(&table);
        scenes_view view = {.device = plan->device,
                            .scene = &scene,
                            .name = base->name,
                            .width = WIDTH,
                            .height = HEIGHT};
        good = scenes_measure(&view, pipelines, look, &f, &table);
        base_progress_step(progress, light ? "moving light" : "moving camera");
    }
    if (good)
        write_film(out, light ? "light" : "camera", &f, &table);
    scenes_table_free(&table);
    for (size_t i = 0; i < PIPELINES; i++)
        for (int t = 0; t < 3; t++)
            free(f.of[i].light[t]);
    return good;
}

static bool both_films(const scenes_plan *plan, const render_scene *scene, FILE *out)
{
    base_progress *progress =
        base_progress_begin("flicker", 2 * (plan->quick ? QUICK_FRAMES : FRAMES));
    bool good = shoot(plan, scene, false, out, progress) && shoot(plan, scene, true, out, progress);
    base_progress_end(progress);
    return good;
}

bool scenes_flicker(const scenes_plan *plan)
{
    return scenes_of_box(plan, "flicker.csv", "moving,pipeline,own_rms,ratio_to_truth\n",
                         both_films);
}
