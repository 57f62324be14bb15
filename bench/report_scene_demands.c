/* report_scene_demands.c: what is asked of more than one view: speed at the paper's resolutions,
 * growth, flicker and the choice of a method. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "report_scenes.h"

static void add_rate(void *context, const scenes_fields *f)
{
    char place[SCENES_PLACE];
    snprintf(place, sizeof place, "%s %sx%s", f->text[0], f->text[1], f->text[2]);
    if (strcmp(f->text[3], "hull") == 0 && f->number[5] > 0.0)
        scenes_note(context, "lighting's speed-up over ground truth, times the paper's", 1.0, true,
                    f->number[4] / f->number[5], place);
}

/* The first and the last amount of what grows. */
typedef struct growth {
    const char *what;
    double amount[2], ms[2], rel[2];
    size_t count;
} growth;

static void add_growth(void *context, const scenes_fields *f)
{
    growth *g = context;
    if (strcmp(f->text[0], g->what) != 0 || strcmp(f->text[2], "hull") != 0)
        return;
    size_t at = g->count++ > 0;
    g->amount[at] = f->number[1];
    g->ms[at] = f->number[3];
    g->rel[at] = fmax(f->number[4], g->rel[at]);
}

static bool growth_bars(report *report, scenes_bars *all)
{
    static const char *const names[] = {"what", "amount", "pipeline", "lighting_ms", "rel", NULL};
    growth triangles = {.what = "triangles"}, lights = {.what = "lights"};
    bool good = scenes_each_row(report, "growth.csv", names, add_growth, &triangles) &&
                scenes_each_row(report, "growth.csv", names, add_growth, &lights);
    char place[SCENES_PLACE];
    snprintf(place, sizeof place, "%.0f to %.0f triangles", triangles.amount[0],
             triangles.amount[1]);
    if (triangles.count > 1)
        scenes_note(all, "lighting time from the fewest to the most triangles, times", 1.1, false,
                    triangles.ms[1] / triangles.ms[0], place);
    snprintf(place, sizeof place, "%.0f to %.0f lights", lights.amount[0], lights.amount[1]);
    if (lights.count > 1) {
        double times = lights.ms[1] / lights.ms[0], linear = lights.amount[1] / lights.amount[0];
        scenes_note(all, "growth of lighting time over that of the number of lights", 1.0, false,
                    times / linear, place);
        scenes_note(all, "rel at every number of lights", .05, false,
                    fmax(lights.rel[0], lights.rel[1]), place);
    }
    return good;
}

/* Flicker of ours and the least of the rivals', while the camera or the light moves. */
typedef struct flicker {
    const char *moving;
    double ours, rivals;
} flicker;

static void add_flicker(void *context, const scenes_fields *f)
{
    flicker *k = context;
    if (strcmp(f->text[0], k->moving) != 0)
        return;
    if (strcmp(f->text[1], "hull") == 0)
        k->ours = f->number[2];
    else if (strncmp(f->text[1], "upsample", 8) == 0)
        k->rivals = fmin(k->rivals, f->number[2]);
}

static bool flicker_bars(report *report, scenes_bars *all)
{
    static const char *const names[] = {"moving", "pipeline", "own_rms", NULL};
    flicker of[2] = {{"camera", (double)NAN, (double)INFINITY},
                     {"light", (double)NAN, (double)INFINITY}};
    for (size_t i = 0; i < 2; i++) {
        if (!scenes_each_row(report, "flicker.csv", names, add_flicker, &of[i]))
            return false;
        if (!isnan(of[i].ours) && isfinite(of[i].rivals))
            scenes_note(all, "flicker, times that of the best rival", 1.0, false,
                        of[i].ours / of[i].rivals, i ? "a moving light" : "a moving camera");
    }
    return true;
}

/* Lighting and integration of the smaller of two sizes of a view. */
typedef struct pixels {
    scenes_bars *all;
    size_t count;
    struct {
        char scene[SCENES_PLACE];
        double lighting, integration;
    } small[64];
} pixels;

static void add_pixels(void *context, const scenes_fields *f)
{
    pixels *p = context;
    if (strcmp(f->text[2], "hull") != 0 || strcmp(f->text[1], "smooth") != 0)
        return;
    size_t i = 0;
    while (i < p->count && strcmp(p->small[i].scene, f->text[0]) != 0)
        i++;
    if (i < p->count) {
        scenes_note(
            p->all, "growth of lighting time with pixels, times the integration's", 1.0, false,
            (f->number[3] / p->small[i].lighting) / (f->number[4] / p->small[i].integration),
            f->text[0]);
    } else if (i < sizeof p->small / sizeof *p->small) {
        snprintf(p->small[i].scene, sizeof p->small[i].scene, "%s", f->text[0]);
        p->small[i].lighting = f->number[3];
        p->small[i].integration = f->number[4];
        p->count++;
    }
}

/* The cheapest method whose picture changes by less than one step; of a pipeline where there is
 * none, what the best one changes. */
typedef struct choice {
    scenes_bars *all;
    char pipeline[SCENES_PLACE];
    double change;
} choice;

static void note_choice(const choice *c)
{
    if (c->pipeline[0] != '\0')
        scenes_note(c->all, "change of the picture by the method chosen for the scene, of 255", 1.0,
                    false, c->change, c->pipeline);
}

/* Rows go from the cheapest to the dearest. */
static void add_choice(void *context, const scenes_fields *f)
{
    choice *c = context;
    if (strcmp(c->pipeline, f->text[1]) != 0) {
        note_choice(c);
        snprintf(c->pipeline, sizeof c->pipeline, "%s", f->text[1]);
        c->change = f->number[2];
    } else if (c->change >= 1.0) {
        c->change = fmin(c->change, f->number[2]);
    }
}

bool scenes_note_others(report *report, scenes_bars *all)
{
    static const char *const rates[] = {"scene",          "width",       "height", "pipeline",
                                        "lighting_ratio", "paper_ratio", NULL};
    static const char *const sizes[] = {"scene",       "normals",      "pipeline",
                                        "lighting_ms", "integrate_ms", NULL};
    static const char *const choices[] = {"scene", "pipeline", "largest_change_of_255", NULL};
    pixels small = {.all = all};
    choice chosen = {.all = all};
    bool good = scenes_each_row(report, "rates.csv", rates, add_rate, all) &&
                growth_bars(report, all) &&
                scenes_each_row(report, "bars.csv", sizes, add_pixels, &small) &&
                flicker_bars(report, all) &&
                scenes_each_row(report, "choice.csv", choices, add_choice, &chosen);
    note_choice(&chosen);
    return good && report_area_bars(report, all);
}
