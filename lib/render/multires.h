/* multires.h: fragments of several resolutions: what multires and nichols share. */
#ifndef RENDER_MULTIRES_H
#define RENDER_MULTIRES_H

#include "shadows.h"

/* The push constants of shaders/multires/fragments.glsl. */
typedef struct multires_push {
    uint32_t tiles[2], level, differing, steep;
    float plane_limit, normal_limit;
    uint32_t points, together;
    uint32_t first_light, last_light, first_round, last_round;
    float tolerance;
} multires_push;

/* Of the 64 points of a light: POINTS_ of fragments.glsl. */
enum multires_points { MULTIRES_SAME, MULTIRES_BOTH, MULTIRES_APART };

typedef struct multires_settings {
    uint32_t differing, steep;       /* bits */
    float tolerance;                 /* over the mean irradiance; MULTIRES_BOTH, else it is 0 */
    float plane_limit, normal_limit; /* pixels, 1 */
    enum multires_points points;
    uint32_t together; /* fragments in a work group */
    uint32_t at_once;  /* lights in a dispatch */
    bool lobes;        /* lights that are visible as a whole are taken as spherical Gaussians */
} multires_settings;

/* A pixel's discontinuity from its neighbours, as in shaders/multires/pyramids.comp. */
extern const multires_settings multires_default;

enum { MULTIRES_TILE = 16, MULTIRES_FRAGMENTS = 341 /* of all levels in 16 x 16 pixels */ };

typedef struct multires {
    shadows shadows;
    multires_push push[RENDER_LEVELS]; /* one a level */
    size_t tiles;
    gpu_buffer *work, *lists, *pyramid, *illumination;
    gpu_compute *pyramids, *cull, *mean; /* mean: NULL where nothing is tolerated */
} multires;

gpu_status multires_create(render_frame *frame, const multires_settings *settings, multires *m);
void multires_destroy(multires *m);

/* A pass of fragments.glsl; own: the kind of binding 13, where the pass has one. */
gpu_status multires_compute(render_frame *frame, const char *path, const gpu_binding *own,
                            gpu_compute **compute);
/* A step of such a pass for all lights, own at binding 13. */
gpu_step multires_step(const render_frame *frame, const multires *m, const char *name,
                       gpu_compute *compute, int level, void *own);
/* The same over a list of fragments. */
gpu_step multires_list_step(const render_frame *frame, const multires *m, const char *name,
                            gpu_compute *compute, int level, int list, void *own);
enum { MULTIRES_FIRST_STEPS = 6 };
/* Resetting, the mean irradiance where it is needed, the pyramids and the first fragments. Returns
 * how many steps were written, at most MULTIRES_FIRST_STEPS. */
int multires_begin(const render_frame *frame, const multires *m, gpu_step *steps);

/* Writes fragments.png into the folder: levels 0 to 4 red, orange, yellow, green, blue. */
bool multires_dump(const render_frame *frame, const multires *m, const char *folder);

/* The state of multires_pipeline by other settings. */
gpu_status multires_create_state(render_frame *frame, const multires_settings *settings,
                                 void **state);

/* The same for nichols_pipeline: differing, plane_limit and normal_limit count. */
gpu_status nichols_create_state(render_frame *frame, const multires_settings *settings,
                                void **state);

extern const render_pipeline multires_pipeline, multires_same_pipeline, multires_apart_pipeline,
    multires_lobe_pipeline, nichols_pipeline;

#endif
