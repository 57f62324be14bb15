/* bvh.h: a tree of boxes around a scene's triangles, built by Embree's builder and laid out for
 * shaders/trace/trace.glsl. */
#ifndef RENDER_BVH_H
#define RENDER_BVH_H

#include "gpu/pass.h"
#include "render/scene.h"

/* References: RENDER_BVH_EMPTY, none; or an inner node's number; or, with the highest bit, a leaf:
 * the number of its first triangle times 8, plus how many there are, less 1. */
#define RENDER_BVH_EMPTY 0x7fffffffu
#define RENDER_BVH_LEAF  0x80000000u
enum {
    RENDER_BVH_DEPTH = 60,    /* of inner nodes at most: what the shader's stack holds */
    RENDER_BVH_MOST = 1 << 27 /* triangles */
};

typedef struct render_bvh {
    uint32_t root; /* number of an inner node */
    uint32_t depth;
    size_t node_count, triangle_count;
    /* 8 a node. Number 0 is none but the grid: floats, its origin, its steps along the axes, 0, 0.
     * Of the others: three words of the first child's box, three of the second's, each low + 65536
     * high in steps of the grid along an axis; then a reference to each. A box holds what is below
     * it with a margin for the roundings of origin + steps * step in float. A child that is not
     * there, in a root of less than two leaves, is RENDER_BVH_EMPTY with the other's box. */
    uint32_t *nodes;
    /* 12 a triangle, in the order of the leaves: three corners, each followed by a word: the number
     * of the triangle in the scene (bits of a uint32) after the first, 0 after the others */
    float *triangles;
} render_bvh;

/* A scene without triangles has a root without children. GPU_UNSUPPORTED where the program was
 * built without Embree, or for more than RENDER_BVH_MOST triangles; the tree is then empty. The
 * same scene gives the same tree. */
gpu_status render_bvh_build(const render_scene *scene, render_bvh *bvh);
void render_bvh_free(render_bvh *bvh);

#endif
