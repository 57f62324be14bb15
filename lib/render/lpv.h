/* lpv.h: one bounce of indirect light by a light propagation volume (Kaplanyan and Dachsbacher
 * 2010), fed by Poisson-disk samples on the scene's surfaces (Koa and Johan 2016).
 *
 * Units: a sample that receives the irradiance E (W/m^2) stands for the area A (m^2) of the surface
 * around it and gives back the flux albedo * E * A (W). A voxel holds the radiant intensity (W/sr)
 * of the light that leaves it in one step as second-order spherical harmonics: the constant and the
 * three linear ones, 4 coefficients a colour. Koa and Johan divide what a voxel received by the
 * number of its samples; a mean intensity alone would leave the brightness to the size of the
 * voxels, so here the mean is weighted by area and multiplied by the surface's area in the voxel:
 * flux is right, and does not depend on how many samples there are. */
#ifndef RENDER_LPV_H
#define RENDER_LPV_H

#include "shadows.h"

#define LPV_USUAL_VOLUME 24 /* voxels along the longest side where none are asked for */
enum { LPV_MOST_VOLUME = 96, LPV_MOST_STEPS = 1024, LPV_MOST_SAMPLES = 16000 };

/* ---- lpv_samples.c: Poisson-disk samples ---------------------------------------------- */

/* As shaders/lpv/samples.glsl has it. Surfaces have two sides: the first is the one that the face
 * normal points to. */
typedef struct lpv_sample {
    float position[4]; /* w: its area, m^2 */
    float normal[4];   /* interpolated, on the first side; w: 0 */
    float face[4];     /* of the triangle; w: 0 */
    float albedo[4];   /* w: 0 */
} lpv_sample;

/* A point of the dense set that the samples are chosen from; each stands for the same area. */
typedef struct lpv_dart {
    float position[3], face[3];
    uint32_t sample; /* nearest one, of those of the same direction if it can be */
} lpv_dart;

typedef struct lpv_samples {
    size_t count, dart_count;
    lpv_sample *samples;
    lpv_dart *darts;
    double radius;    /* no two samples are closer, m */
    double dart_area; /* m^2 */
} lpv_samples;

/* About `wanted` samples (within a factor of two on smooth surfaces, fewer on crumpled ones), at
 * least `radius` apart, and no dart farther than that from all: darts in a fixed random order, each
 * kept where no earlier one is near (Cook 1986), found by a grid of cells as in Bridson 2007, here
 * hashed. darts: how many, spread evenly by area; at least wanted. A scene without surfaces has
 * none. Free with lpv_samples_free. */
void lpv_samples_make(const render_scene *scene, size_t wanted, size_t darts, lpv_samples *samples);
void lpv_samples_free(lpv_samples *samples);

/* ---- lpv_volume.c: the volume and what the surfaces are in it -------------------------- */

/* Voxel (x, y, z) has the number x + size[0] * (y + size[1] * z). */
typedef struct lpv_volume {
    uint32_t size[3];
    double low[3], side; /* corner, and side of a voxel in m */
    size_t voxels;
    /* What is deposited where: entries[first[v]] up to entries[first[v + 1]] are of voxel v. A side
     * of a surface belongs to the voxel that half a voxel's side along the normal leads to, so that
     * it does not shadow itself; what lies outside has left through the boundary. */
    uint32_t *first; /* voxels + 1 */
    struct lpv_entry {
        uint32_t side; /* 2 * sample + (0: the face normal's side, 1: the other) */
        float area;    /* m^2 */
    } * entries;
    size_t entry_count;
    /* The geometry volume, offset by half a voxel: 4 floats a voxel, the share of light that goes
     * on from its centre to that of the neighbour at +x, +y and +z; 0. Of surfaces between the two
     * centres, by their area as seen along the axis over the area of a voxel's face, at most 1: the
     * cube of that is kept. A whole wall keeps everything; surfaces that lie askew or cover a part
     * give light themselves there, which must get out (the power was found by trying). */
    float *open;
} lpv_volume;

/* volume: voxels along the longest side, 1 to LPV_MOST_VOLUME. */
void lpv_volume_make(const render_scene *scene, const lpv_samples *samples, uint32_t volume,
                     lpv_volume *result);
void lpv_volume_free(lpv_volume *volume);

/* ---- lpv.c: the passes ----------------------------------------------------------------- */

typedef struct lpv_settings {
    uint32_t volume, steps;  /* 0: the default; of steps, twice the volume */
    uint32_t samples, darts; /* as for lpv_samples_make */
    uint32_t points;         /* of the 64 of each light that a sample sees: 16 or 64 */
    bool printed;            /* propagation as Kaplanyan and Dachsbacher print it */
    float sharpest;          /* see shaders/lpv/volume.glsl: below 1 */
    float lift;              /* the look-up is that many voxel sides above the surface */
} lpv_settings;

extern const lpv_settings lpv_default;

/* Push constants of shaders/lpv/volume.glsl. */
typedef struct lpv_push {
    uint32_t size[3], voxels;
    float low[3], side;
    float lift, sharpest;
} lpv_push;

typedef struct lpv {
    shadows shadows;
    lpv_settings settings;
    uint32_t samples; /* 0: nothing to do */
    lpv_push push;
    gpu_buffer *sample_data, *reflected, *emitters;       /* gather.comp */
    gpu_buffer *first, *entries, *open, *lobes[2], *sums; /* the volume */
    gpu_image *light;                                     /* changes places with frame->light */
    gpu_compute *gather, *deposit, *propagate, *look_up;
} lpv;

/* GPU_UNSUPPORTED without Embree or where the volume needs a buffer above 128 MiB. */
gpu_status lpv_create(render_frame *frame, const lpv_settings *settings, lpv **result);
void lpv_destroy(lpv *lpv); /* NULL is fine */

/* Adds the light that one diffuse reflection brings to frame->light where that holds light, from
 * area lights and, with texels, from those of the reflective shadow map. */
gpu_status lpv_run(render_frame *frame, lpv *lpv, bool texels, render_statistics *statistics);

#endif
