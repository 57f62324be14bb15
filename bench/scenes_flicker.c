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
#include "scenes_film.h"

enum { WIDTH = 480, HEIGHT = 270, FRAMES = 60, QUICK_FRAMES = 6, MOST_PIPELINES = 16 };
static const char *const pipelines[] = {"meder",        "hull",         "hull_lobe",
                                        "upsample2",    "upsample4",    "upsample8",
                                        "upsample_sh8", "upsample_far", NULL};

/* The last three frames of one pipeline, and its sums over pixels and frames. */
typedef struct history {
    char pipeline[SCENES_NAME];
    int frames;      /* that it made */
    float *light[3]; /* 4 floats a pixel */
    double own, all,
        truth; /* sums of squared second differences: of the error, of E, of the truth */
} history;

typedef struct film {
    history of[MOST_PIPELINES]; /* the truth first */
    size_t pixels;
    int frame;
    size_t count; /* pipelines so far */
    double mean;  /* of the truth in this frame */
} film;

static double mean_of(size_t pixels, const float *truth)
{
    double sum = 0.0, count = 0.0;
    for (size_t i = 0; i < pixels; i++)
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
static void accumulate(size_t pixels, history *h, const history *truth, double mean)
{
    double values = 3.0 * (double)pixels;
    for (size_t p = 0; p < pixels; p++) {
        bool there = true;
        for (int t = 0; t < 3; t++)
            there = there && truth->light[t][4 * p + 3] != 0.0f;
        for (size_t c = 0; c < 3 && there; c++) {
            double all = second_difference(h->light, 4 * p + c) / mean,
                   real = second_difference(truth->light, 4 * p + c) / mean;
            h->own += (all - real) * (all - real) / values;
            h->all += all * all / values;
            h->truth += real * real / values;
        }
    }
}

/* By its name: a pipeline may be left out of a frame. NULL: too many. */
static history *history_of(film *f, const char *pipeline)
{
    size_t i = 0;
    while (i < f->count && strcmp(f->of[i].pipeline, pipeline) != 0)
        i++;
    if (i == MOST_PIPELINES)
        return NULL;
    if (i == f->count)
        snprintf(f->of[f->count++].pipeline, SCENES_NAME, "%s", pipeline);
    return &f->of[i];
}

static bool look(void *context, render_frame *frame, const scenes_row *row, const float *light,
                 const float *truth, const float *errors)
{
    film *f = context;
    (void)frame;
    (void)errors;
    history *h = history_of(f, row->pipeline);
    if (!h)
        return true;
    float *oldest = h->light[0];
    h->light[0] = h->light[1];
    h->light[1] = h->light[2];
    h->light[2] = oldest;
    memcpy(oldest, light, f->pixels * 4 * sizeof *oldest);
    h->frames++;
    if (h == &f->of[0])
        f->mean = mean_of(f->pixels, truth);
    if (f->frame >= 2)
        accumulate(f->pixels, h, &f->of[0], f->mean);
    return true;
}

/* A swing: 0 in the first frame, 1, 0, -1, and 0 again after the last. */
static double swing(int frame, int frames)
{
    return sin(2.0 * 3.14159265358979323846 * frame / (double)frames);
}

/* The eye around its target by 6 degrees times t. */
static void swing_camera(render_scene *scene, const render_scene *base, double t)
{
    double angle = t * 6.0 * 3.14159265358979323846 / 180.0,
           x = base->camera.eye[0] - base->camera.target[0],
           z = base->camera.eye[2] - base->camera.target[2];
    scene->camera.eye[0] = base->camera.target[0] + x * cos(angle) - z * sin(angle);
    scene->camera.eye[2] = base->camera.target[2] + x * sin(angle) + z * cos(angle);
}

/* The light's target moves by a tenth of the scene's size. */
static void swing_spot(render_scene *scene, const render_scene *base, double t)
{
    scene->spot.target[0] = base->spot.target[0] + 0.1 * t * (base->high[0] - base->low[0]);
}

/* Of pipelines that made every frame. */
static void write_film(FILE *out, const char *what, const film *f)
{
    for (size_t i = 0; i < f->count; i++) {
        const history *h = &f->of[i];
        double frames = f->frame > 2 ? f->frame - 2 : 1;
        char own[BASE_NUMBER_SIZE], ratio[BASE_NUMBER_SIZE];
        if (h->frames == f->frame)
            fprintf(out, "%s,%s,%s,%s\n", what, h->pipeline,
                    base_shortest_f64(sqrt(h->own / frames), own),
                    base_shortest_f64(h->truth > 0.0 ? sqrt(h->all / h->truth) : 1.0, ratio));
    }
}

typedef void move(render_scene *scene, const render_scene *base, double t);

static bool shoot_one(const scenes_plan *plan, const render_scene *base, const scenes_film *shot,
                      const char *moving, move *moved, FILE *out)
{
    film f = {.pixels = (size_t)shot->width * shot->height};
    for (size_t i = 0; i < MOST_PIPELINES; i++)
        for (int t = 0; t < 3; t++)
            f.of[i].light[t] = base_allocate(f.pixels * 4 * sizeof(float));
    base_progress *progress = base_progress_begin("flicker", (size_t)shot->frames);
    bool good = true;
    for (f.frame = 0; f.frame < shot->frames && good; f.frame++) {
        render_scene scene = *base;
        moved(&scene, base, swing(f.frame, shot->frames));
        scenes_table table = {0};
        scenes_view view = {.device = plan->device,
                            .scene = &scene,
                            .name = base->name,
                            .width = shot->width,
                            .height = shot->height,
                            .truth = shot->truth};
        good = scenes_measure(&view, shot->pipelines, look, &f, &table);
        scenes_table_free(&table);
        base_progress_step(progress, moving);
    }
    base_progress_end(progress);
    if (good)
        write_film(out, moving, &f);
    for (size_t i = 0; i < MOST_PIPELINES; i++)
        for (int t = 0; t < 3; t++)
            free(f.of[i].light[t]);
    return good;
}

bool scenes_shoot(const scenes_plan *plan, const render_scene *base, const scenes_film *shot,
                  FILE *out)
{
    return shoot_one(plan, base, shot, "camera", swing_camera, out) &&
           shoot_one(plan, base, shot, "light", shot->move_light, out);
}

static bool both_films(const scenes_plan *plan, const render_scene *scene, FILE *out)
{
    scenes_film film = {.pipelines = pipelines,
                        .width = WIDTH,
                        .height = HEIGHT,
                        .frames = plan->quick ? QUICK_FRAMES : FRAMES,
                        .move_light = swing_spot};
    return scenes_shoot(plan, scene, &film, out);
}

bool scenes_flicker(const scenes_plan *plan)
{
    return scenes_of_box(plan, "flicker.csv", SCENES_FILM_COLUMNS, both_films);
}
