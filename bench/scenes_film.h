/* scenes_film.h: frames of something that moves by several pipelines: how much of the change in
 * time is the pipeline's own. */
#ifndef BENCH_SCENES_FILM_H
#define BENCH_SCENES_FILM_H

#include "scenes.h"

#define SCENES_FILM_COLUMNS "moving,pipeline,own_rms,ratio_to_truth\n"

typedef struct scenes_film {
    const char *truth; /* NULL: `exact` */
    const char *const *pipelines;
    uint32_t width, height;
    int frames;
    /* Moves the light of the scene, which is a copy of base, by t from -1 to 1. */
    void (*move_light)(render_scene *scene, const render_scene *base, double t);
} scenes_film;

/* Twice: "camera", the eye moves around its target by 6 degrees to both sides, and "light". Writes
 * a row for each pipeline: root mean square over pixels of the second difference in time of the
 * error, relative to the mean of the truth; and of the irradiance, over that of the truth. */
bool scenes_shoot(const scenes_plan *plan, const render_scene *base, const scenes_film *film,
                  FILE *out);

#endif
