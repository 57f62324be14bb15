/* hull_private.h: the state of the pipeline, shared by its files. */
#ifndef RENDER_HULL_PRIVATE_H
#define RENDER_HULL_PRIVATE_H

#include "hull.h"
#include "hull_tree.h"

/* Push of shaders/hull/hull.glsl. */
typedef struct hull_push {
    uint32_t tiles_x, tiles_y, level, vertex_capacity, corner_capacity;
    uint32_t quad_first[HULL_LEVELS + 1];
    float link_plane, link_cosine, split, tau, tau_width, near_pixels;
    uint32_t factor, blocks_x, blocks_y;
    float plane, power, least;
    uint32_t has_even;
    uint32_t nodes_end;
    float merge;
} hull_push;

/* Words of Control in shaders/hull/control.glsl. */
enum {
    HULL_CLAIM_GROUPS = 0,
    HULL_GATHER_GROUPS = 3,
    HULL_SPLIT_GROUPS = 6,
    HULL_LEAF_GROUPS = 9,
    HULL_NEAR_GROUPS = 12,
    HULL_DRAW = 15,
    HULL_DRAW_EVEN = 19,
    HULL_LEAF_COUNT = 23,
    HULL_NEAR_COUNT,
    HULL_VERTEX_COUNT,
    HULL_GATHER_FIRST,
    HULL_GATHER_END,
    HULL_QUAD_COUNT,
    HULL_MEAN = HULL_QUAD_COUNT + 5,
    HULL_PLAIN_GROUPS = HULL_MEAN + 1 + 2 * HULL_RANKS + 1,
    HULL_EVEN_GROUPS = HULL_PLAIN_GROUPS + 3,
    HULL_EVEN_COUNT = HULL_EVEN_GROUPS + 3,
    HULL_CONTROL_WORDS = HULL_EVEN_COUNT + 3
};

typedef enum hull_pass {
    HULL_TREE_IMAGE,
    HULL_LINKS,
    HULL_COMPONENTS,
    HULL_CLAIM,
    HULL_MEAN_SAMPLES,
    HULL_MEAN_SUM,
    HULL_NEXT,
    HULL_GATHER,
    HULL_GATHER_EVEN,
    HULL_SPLIT,
    HULL_PART,
    HULL_SHARE,
    HULL_BLEND,
    HULL_EMIT,
    HULL_CULL_TILE,
    HULL_CULL,
    HULL_NEAR,
    HULL_EXACT,
    HULL_GATHER_LOBES,
    HULL_FIT_LOBES,
    HULL_SPLIT_LOBES,
    HULL_BLEND_LOBES,
    HULL_BOUNDS,
    HULL_GATHER_FAR,
    HULL_GATHER_ALL,
    HULL_UPSAMPLE_FAR,
    HULL_PASSES
} hull_pass;

typedef enum hull_buffer {
    HULL_B_CONTROL,
    HULL_B_ARGUMENTS,  /* of the exact pass */
    HULL_B_EXACT,      /* its pixels */
    HULL_B_LINKS,      /* uvec4 a row of a tile */
    HULL_B_ROW_BOUNDS, /* 4 Bounds for HULL_ROWS rows of a tile */
    HULL_B_MASKS,      /* 32 words a component */
    HULL_B_COMPONENTS, /* label and number of pixels */
    HULL_B_MAP,        /* a word a pixel */
    HULL_B_EVEN_MAP,   /* the same */
    HULL_B_VERTEX_PIXELS,
    HULL_B_VERTICES,
    HULL_B_TILTED, /* 16 bytes a vertex of lobes */
    HULL_B_SHARES, /* a word a vertex */
    HULL_B_QUADS,  /* HULL_QUAD_BYTES each */
    HULL_B_LEAVES,
    HULL_B_CORNERS, /* 16 bytes each */
    HULL_B_EVEN_CORNERS,
    HULL_B_SAMPLES,
    HULL_B_BLOCK_BOUNDS,
    HULL_B_TILE_LISTS,
    HULL_B_NEAR_LISTS,
    HULL_B_NEAR_BLOCKS,
    HULL_B_FAR_SAMPLES,
    HULL_B_TREE, /* light_node each */
    HULL_BUFFERS
} hull_buffer;

typedef struct hull {
    hull_kind kind;
    float tau; /* of the settings; push.tau is that for the lights of the frame */
    hull_push push;
    uint32_t tiles, blocks;
    gpu_compute *passes[HULL_PASSES];
    gpu_draw *draw, *draw_even;
    gpu_buffer *buffers[HULL_BUFFERS];
    gpu_image *tree; /* what shaders read: see LIGHT_NODES_ACROSS */
} hull;

/* A list of steps in the making. */
typedef struct hull_list {
    const render_frame *frame;
    const hull *h;
    hull_push pushes[HULL_LEVELS + 2]; /* by level */
    gpu_step steps[64];
    int count;
} hull_list;

/* hull_buffers.c: and the tree's image; sets the sizes in h->push */
gpu_status hull_create_buffers(render_frame *frame, hull *h, const hull_settings *settings);

/* hull_passes.c */
gpu_status hull_create_pass(render_frame *frame, hull *h, hull_pass pass);
gpu_status hull_create_draw(render_frame *frame, hull *h);
gpu_step *hull_add(hull_list *l, const char *name, hull_pass pass, int level);
void hull_add_groups(hull_list *l, const char *name, hull_pass pass, uint32_t groups);
/* with as many groups as this word of Control, or for the exact pass of Arguments, says */
void hull_add_indirect(hull_list *l, const char *name, hull_pass pass, int level, int word);
void hull_add_fill(hull_list *l, const char *name, hull_buffer buffer, uint32_t bits);
void hull_add_draw(hull_list *l);
gpu_status hull_profile(render_frame *frame, void *state, float **points, size_t *count);

#endif
