/* meder.h: the pipeline `meder`, the paper's own, as its parts: for meder.c, its pictures and its
 * tests. Steps, buffers and layouts are those of shaders/meder. */
#ifndef RENDER_MEDER_H
#define RENDER_MEDER_H

#include "render.h"

enum {
    MEDER_SIDE = 1024, /* of the downsampled depth */
    MEDER_TILE = 32,
    MEDER_TILES = MEDER_SIDE / MEDER_TILE, /* along a side */
    MEDER_MOST_SEGMENTS = MEDER_SIDE * MEDER_SIDE
};

/* Struct Box of meder.glsl. */
typedef struct meder_box {
    uint32_t low[2], high[2]; /* texels, both included */
    float z_low, z_high;
    uint32_t segment; /* tile * 1024 + label */
    uint32_t unused;
} meder_box;

/* What dump.vert writes. */
typedef struct meder_record {
    float before[3], surface; /* position in the G-buffer at the corner; surface: 0 where none */
    float after[3], corrected;
    float lobes[3][4]; /* red, green, blue: axis and sharpness */
    float amplitude[3], unused;
} meder_record;

/* The steps of a frame, in this order. */
enum { MEDER_DOWNSAMPLE, MEDER_SEGMENT, MEDER_BOXES, MEDER_QUADS, MEDER_LIGHT, MEDER_STEPS };

typedef struct meder {
    float threshold; /* the paper's t */
    gpu_image *downsampled, *labels;
    gpu_buffer *boxes;    /* 1024 a tile, the first counts[tile] of them used */
    gpu_buffer *counts;   /* segments of each tile */
    gpu_buffer *quads;    /* indices of boxes, tile after tile */
    gpu_buffer *indirect; /* VkDrawIndexedIndirectCommand */
    gpu_buffer *indices;  /* 6 a quad */
    gpu_compute *downsample, *segment, *box, *list;
    gpu_draw *light;
} meder;

extern const render_pipeline meder_pipeline;

void meder_steps(render_frame *frame, meder *m, gpu_step steps[MEDER_STEPS]);

/* Segments of the last run. */
uint32_t meder_quad_count(const meder *m);

/* The bindings of the step that draws, and of the one of the dump, which has one more. */
enum { MEDER_DRAW_BINDINGS = 9 };
void meder_draw_bindings(gpu_binding bindings[MEDER_DRAW_BINDINGS + 1]);
void meder_draw_resources(render_frame *frame, meder *m, void **resources);

/* After a run: what the vertex stage made of each corner, 4 records a quad in the order of the
 * list, and (lobes not NULL) for each pixel the interpolated axis and sharpness of the green lobe,
 * 4 floats, 0 where none was drawn. free() both. */
gpu_status meder_record_corners(render_frame *frame, meder *m, meder_record **records,
                                float **lobes);

/* render_pipeline.dump and .profile. */
bool meder_dump(render_frame *frame, void *state, const char *folder);
gpu_status meder_profile(render_frame *frame, void *state, float **points, size_t *count);

#endif
