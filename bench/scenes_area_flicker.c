/* scenes_area_flicker.c: area lights with shadows while the camera or the lights move. */
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "scenes_film.h"

static const char *const pipelines[] = {"multires", "nichols", "shadows2", NULL};
enum { MOST_LIGHTS = 16 };

/* To and fro by a twentieth of the scene's size. */
static void swing_lights(render_scene *scene, const render_scene *base, double t)
{
    static render_area_light moved[MOST_LIGHTS]; /* as long as the frame */
    scene->area_light_count =
        base->area_light_count < MOST_LIGHTS ? base->area_light_count : (size_t)MOST_LIGHTS;
    scene->area_lights = moved;
    for (size_t i = 0; i < scene->area_light_count; i++) {
        moved[i] = base->area_lights[i];
        for (int c = 0; c < moved[i].corner_count; c++)
            moved[i].corners[c][0] += 0.05 * t * (base->high[0] - base->low[0]);
    }
}

static bool both_films(const scenes_plan *plan, const render_scene *scene, FILE *out)
{
    scenes_film film = {.truth = "shadows",
                        .pipelines = pipelines,
                        .width = plan->quick ? 64 : 160,
                        .height = plan->quick ? 48 : 120,
                        .frames = plan->quick ? 3 : 60,
                        .move_light = swing_lights};
    return scenes_shoot(plan, scene, &film, out);
}

bool scenes_area_flicker(const scenes_plan *plan)
{
    return scenes_of_area_box(plan, "area_flicker.csv", SCENES_FILM_COLUMNS, both_films);
}
