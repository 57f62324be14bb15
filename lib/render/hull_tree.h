/* hull_tree.h: a tree over the lights of a frame, in which a group of lights that is far stands for
 * all of them. */
#ifndef RENDER_HULL_TREE_H
#define RENDER_HULL_TREE_H

#include "internal.h"

/* struct Node of shaders/hull/tree.glsl. The nodes come in the order in which a descent meets them:
 * a node, then what is below it, then the next one; the lights themselves are the leaves. */
typedef struct light_node {
    /* The light itself. Above the leaves: one triangle with the flux of all lights below in the
     * direction that they shine to, and with their centre and their covariance in its plane. */
    light_data light;
    float middle[3], radius; /* a sphere around the lights below */
    float axis[3], power; /* the triangle's normal; flux of the lights, mean of the channels (W) */
    float spread;         /* greatest distance of a normal of theirs from the axis */
    float bend;           /* (how far their centres are from the plane, over the radius)^2 */
    float slack;          /* how far the middle is from the plane of any of them */
    float reach;          /* of a sphere that holds discs of their area */
    float strongest, smallest; /* greatest flux, least area of a light */
    uint32_t skip;             /* the node that comes after all that is below; of a leaf the next */
    uint32_t index;            /* of a leaf: of its light; else UINT32_MAX */
} light_node;

/* Shaders read the nodes from an image of 32 bit words, four a texel: 8 texels a node, and as many
 * nodes a row, NODES_ACROSS of tree.glsl. */
enum { LIGHT_NODE_TEXELS = 8, LIGHT_NODES_ACROSS = 256 };

/* At most as many nodes as twice the lights. Every node has up to four below it, of numbers of
 * lights that differ by one at most: the lights are halved twice, each time along the place or
 * the normal in which they differ most. hierarchy: without it there are leaves alone, in the
 * order of the lights. Returns the number of nodes. The same lights give the same tree. */
size_t light_tree_build(const light_data *lights, size_t count, bool hierarchy, light_node *nodes);

/* ---- For the two files of the tree ---------------------------------------------------- */

enum { LIGHT_DIMENSIONS = 6 };

typedef struct light_emitter {
    double place[LIGHT_DIMENSIONS]; /* centre, then the normal times a length */
    double power;                   /* flux, mean of the channels */
    uint32_t index;                 /* of the light */
} light_emitter;

/* All but skip. turned: the triangle points the other way, so that what the third moments of
 * neighbours miss cancels. */
void light_node_make(const light_data *lights, const light_emitter *emitters, size_t count,
                     bool turned, light_node *node);

void light_centre(const light_data *light, double centre[3]);

#endif
