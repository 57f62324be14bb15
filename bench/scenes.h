/* scenes.h: what the renderer's pipelines are worth on scenes: errors against ground truth, light
 * evaluations and time, as tables and pictures. Private to bench. */
#ifndef BENCH_SCENES_H
#define BENCH_SCENES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "render/render.h"

enum { SCENES_NAME = 48 };

/* One pipeline on one view. */
typedef struct scenes_row {
    char scene[SCENES_NAME], pipeline[SCENES_NAME], method[SCENES_NAME];
    uint32_t width, height;
    bool detailed; /* strong detail on the shading normals */
    render_statistics statistics;
    render_comparison error; /* against the pipeline `exact` */
    double jump_p99;         /* of the change of the error from a pixel to its right neighbour, 99th
                                percentile */
    double lighting_ms;      /* all passes of the pipeline, median of the runs */
    double truth_ms;         /* the same of `exact`, in the same interleaved runs */
    double frame_ms;         /* what every pipeline shares: G-buffer, shadow map, albedo */
    void *state;             /* the pipeline's, while it is looked at; then NULL */
} scenes_row;

typedef struct scenes_table {
    scenes_row *rows;
    size_t count;
} scenes_table;

/* A pipeline with settings of its own, beside those that have an id. */
typedef struct scenes_variant {
    char id[SCENES_NAME];
    const render_pipeline *like; /* runs and destroys it */
    gpu_status (*create)(render_frame *frame, const void *settings, void **state);
    const void *settings;
} scenes_variant;

/* Pipelines that have run on the device: its driver has compiled their shaders. */
typedef struct scenes_warmth {
    const render_pipeline *of[64];
    size_t count;
} scenes_warmth;

/* What the truth of a view was, so that it is rendered once where the view is measured again. Start
 * with zeros. */
typedef struct scenes_truth {
    scenes_row row;
    float *light; /* free() it; NULL: not yet known */
} scenes_truth;

/* A view: a scene at a size. */
typedef struct scenes_view {
    gpu_device *device;
    const render_scene *scene;
    const char *name;
    uint32_t width, height;
    bool detailed;
    const char *method; /* NULL: the renderer's default */
    const char *truth;  /* pipeline that the others are compared with; NULL: `exact` */
    /* Interleaved: every pipeline once, then every pipeline again; 0: once, and times mean nothing
     */
    int runs;
    double enough_ms; /* the second run that took as long, of the truth the first, is the last; 0:
                         none is */
    scenes_warmth *warm; /* those in it need no run before the first that counts; NULL: all do */
    scenes_truth *known; /* of this view: used, or filled where it is empty; NULL: rendered */
    const scenes_variant *variants; /* after the pipelines */
    size_t variant_count;
} scenes_view;

/* Called once a pipeline, the truth first unless it was known, with what it made: 4 floats a pixel.
 * The frame holds the pipeline's light and image. False ends the measuring. */
typedef bool (*scenes_look)(void *context, render_frame *frame, const scenes_row *row,
                            const float *light, const float *truth, const float *errors);

/* Adds a row for the truth and one for each of the pipelines (ids, NULL-ended) and variants. look
 * may be NULL. A pipeline that the device cannot do is told in a line and has no row; without the
 * truth no other has one either. False after one line. */
bool scenes_measure(const scenes_view *view, const char *const *pipelines, scenes_look look,
                    void *context, scenes_table *table);

void scenes_table_free(scenes_table *table);

/* As CSV: the columns of the row and the times of every pass. False after one line. */
bool scenes_write_csv(const scenes_table *table, const char *path);
bool scenes_write_passes(const scenes_table *table, const char *path);

/* scenes_bars.c: our pipelines beside what is asked of them. An empty field: no such rival ran. */
bool scenes_write_bars(const scenes_table *table, const char *path);

/* ---- scenes_picture.c ------------------------------------------------------------------------ */

/* The frame's picture as SCENE_WHAT.png in a folder. False after one line. */
bool scenes_write_image(const char *folder, const char *what, const scenes_row *row,
                        render_frame *frame);

/* The error of each pixel times four in false colours, green low, red high, black where there is no
 * surface. False after one line. */
bool scenes_write_errors(const char *path, uint32_t width, uint32_t height, const float *errors,
                         const float *truth);

/* ---- The parts of `sgfit bench --scenes` -------------------------------------------------------
 */

typedef struct scenes_plan {
    gpu_device *device;
    const char *folder; /* of the meshes; NULL: the built-in scene alone */
    const char *out;
    bool quick;
    const char *only; /* names of scenes that begin so; NULL: all */
    scenes_warmth *warm;
} scenes_plan;

/* Every view, size and kind of normals by every pipeline: views.csv, passes.csv, pictures/. */
bool scenes_views(const scenes_plan *plan);
/* What each refinement of the hull buys: steps.csv. */
bool scenes_steps(const scenes_plan *plan);
/* The paper's table 1: rates.csv. */
bool scenes_rates(const scenes_plan *plan);
/* The paper's figures 2 to 4: stages/, paper/, paper.csv. */
bool scenes_paper(const scenes_plan *plan);
/* Lighting time over triangles, pixels and lights: growth.csv. */
bool scenes_growth(const scenes_plan *plan);
/* Sixty frames of a moving camera and a moving light: flicker.csv. */
bool scenes_flicker(const scenes_plan *plan);

/* The cheapest method for what a frame integrates, and what it changes: choice.csv. */
bool scenes_choice(const scenes_plan *plan);
/* Area lights with shadows: shadows.csv, shadows/. */
bool scenes_shadows(const scenes_plan *plan);
/* The same by other thresholds of refinement: area_refinement.csv. */
bool scenes_area_refinement(const scenes_plan *plan);
/* The same while camera and lights move: area_flicker.csv. */
bool scenes_area_flicker(const scenes_plan *plan);
/* Indirect light by a volume against traced paths: indirect.csv, indirect/. */
bool scenes_indirect(const scenes_plan *plan);
/* Virtual spherical Gaussian lights by every method: lobes.csv, lobes/. */
bool scenes_lobes(const scenes_plan *plan);

/* The rivals' settings: tune.csv. */
bool scenes_tune(const scenes_plan *plan);

/* Runs a part that writes one CSV of the built-in scene. False after one line. */
typedef bool (*scenes_work)(const scenes_plan *plan, const render_scene *scene, FILE *out);
bool scenes_of_box(const scenes_plan *plan, const char *name, const char *header, scenes_work work);
/* The same of the built-in scene lit by area lights. */
bool scenes_of_area_box(const scenes_plan *plan, const char *name, const char *header,
                        scenes_work work);

/* The descriptions that the plan covers (a quick one: only the first view of each scene), those lit
 * by area lights (NAME_area.json) or the others: paths, free with base_list_free. */
bool scenes_list(const scenes_plan *plan, bool area, char ***paths, size_t *count);

/* Whether the path is not that of a further view of its scene: NAME_2.json and the like. */
bool scenes_is_first_view(const char *path);

#endif
