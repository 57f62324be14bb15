/* The tree of boxes: Embree builds it, in nodes of its own making; then it is laid out depth first,
 * so that a subtree lies together. */
#include "bvh.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#ifdef HAVE_EMBREE

#include <embree3/rtcore.h>
#include <stdalign.h>

enum { LEAF_MOST = 4 };

typedef struct tree_node {
    uint32_t count; /* of triangles; 0: an inner node */
    union {
        struct {
            struct tree_node *child[2];
            float low[2][3], high[2][3];
        };
        uint32_t triangles[LEAF_MOST];
    };
} tree_node;

static void *make_inner(RTCThreadLocalAllocator memory, unsigned children, void *user)
{
    (void)children, (void)user;
    tree_node *node = rtcThreadLocalAlloc(memory, sizeof *node, alignof(tree_node));
    node->count = 0;
    return node;
}

static void set_children(void *node, void **children, unsigned count, void *user)
{
    (void)user;
    for (unsigned i = 0; i < count; i++)
        ((tree_node *)node)->child[i] = children[i];
}

static void set_bounds(void *node, const struct RTCBounds **bounds, unsigned count, void *user)
{
    (void)user;
    for (unsigned i = 0; i < count; i++) {
        const struct RTCBounds *b = bounds[i];
        memcpy(((tree_node *)node)->low[i], (float[3]){b->lower_x, b->lower_y, b->lower_z}, 12);
        memcpy(((tree_node *)node)->high[i], (float[3]){b->upper_x, b->upper_y, b->upper_z}, 12);
    }
}

static void *make_leaf(RTCThreadLocalAllocator memory, const struct RTCBuildPrimitive *primitives,
                       size_t count, void *user)
{
    (void)user;
    tree_node *node = rtcThreadLocalAlloc(memory, sizeof *node, alignof(tree_node));
    node->count = (uint32_t)count;
    for (size_t i = 0; i < count; i++)
        node->triangles[i] = primitives[i].primID;
    return node;
}

static const float *corner(const render_scene *scene, uint32_t triangle, int i)
{
    return scene->positions + 3 * (size_t)scene->indices[3 * (size_t)triangle + (size_t)i];
}

/* Of each triangle; low and high: of the scene. */
static void bound(const render_scene *scene, struct RTCBuildPrimitive *primitives, float low[3],
                  float high[3])
{
    for (int k = 0; k < 3; k++) {
        low[k] = FLT_MAX;
        high[k] = -FLT_MAX;
    }
    for (uint32_t t = 0; t < scene->triangle_count; t++) {
        float l[3], h[3];
        for (int k = 0; k < 3; k++) {
            float a = corner(scene, t, 0)[k], b = corner(scene, t, 1)[k],
                  c = corner(scene, t, 2)[k];
            l[k] = fminf(a, fminf(b, c));
            h[k] = fmaxf(a, fmaxf(b, c));
            low[k] = fminf(low[k], l[k]);
            high[k] = fmaxf(high[k], h[k]);
        }
        primitives[t] = (struct RTCBuildPrimitive){l[0], l[1], l[2], 0, h[0], h[1], h[2], t};
    }
}

static void put_word(float *to, uint32_t word)
{
    memcpy(to, &word, sizeof word);
}

/* What origin + steps * step may be off by on the device, twice rounded, and more. */
static double margin(const float *grid, int k)
{
    return 0x1p-22 * (fabs((double)grid[k]) + 65535.0 * (double)grid[3 + k]);
}

/* 65535 steps of the grid reach over the scene with its margins. */
static void lay_grid(uint32_t *words, const float low[3], const float high[3])
{
    float grid[8] = {0};
    for (int k = 0; k < 3; k++) {
        double size = (double)high[k] - (double)low[k],
               least = 0x1p-20 * fmax(fabs((double)low[k]), fabs((double)high[k]));
        grid[k] = (float)((double)low[k] - least);
        grid[3 + k] = (float)fmax((size + 3 * least) / 65000, 1e-30);
    }
    memcpy(words, grid, sizeof grid);
}

static uint32_t clamp_steps(double steps)
{
    return (uint32_t)fmin(fmax(steps, 0), 65535);
}

static void put_box(const uint32_t *nodes, const float low[3], const float high[3], uint32_t *to)
{
    float grid[8];
    memcpy(grid, nodes, sizeof grid);
    for (int k = 0; k < 3; k++) {
        double origin = (double)grid[k], step = (double)grid[3 + k], m = margin(grid, k);
        uint32_t from = clamp_steps(floor(((double)low[k] - m - origin) / step));
        uint32_t up_to = clamp_steps(ceil(((double)high[k] + m - origin) / step));
        to[k] = from | up_to << 16;
    }
}

static uint32_t flatten_leaf(const render_scene *scene, const tree_node *node, render_bvh *bvh)
{
    size_t first = bvh->triangle_count;
    for (uint32_t i = 0; i < node->count; i++) {
        float *to = bvh->triangles + 12 * bvh->triangle_count++;
        for (int k = 0; k < 3; k++) {
            memcpy(to + 4 * k, corner(scene, node->triangles[i], k), 12);
            put_word(to + 4 * k + 3, k == 0 ? node->triangles[i] : 0);
        }
    }
    return RENDER_BVH_LEAF | (uint32_t)first << 3 | (node->count - 1);
}

static uint32_t flatten(const render_scene *scene, const tree_node *node, uint32_t depth,
                        render_bvh *bvh);

static void flatten_child(const render_scene *scene, const tree_node *child, const float *low,
                          const float *high, uint32_t depth, render_bvh *bvh, size_t at, int i)
{
    uint32_t *to = bvh->nodes + 8 * at;
    put_box(bvh->nodes, low, high, to + 3 * i);
    to[6 + i] =
        child->count > 0 ? flatten_leaf(scene, child, bvh) : flatten(scene, child, depth + 1, bvh);
}

/* An inner node. Recursion as deep as the tree: RENDER_BVH_DEPTH at most. */
static uint32_t flatten(const render_scene *scene, const tree_node *node, uint32_t depth,
                        render_bvh *bvh)
{
    size_t at = bvh->node_count++;
    if (depth + 1 > bvh->depth)
        bvh->depth = depth + 1;
    for (int i = 0; i < 2; i++)
        flatten_child(scene, node->child[i], node->low[i], node->high[i], depth, bvh, at, i);
    return (uint32_t)at;
}

/* A root that is a leaf becomes the one child of an inner node. */
static uint32_t flatten_root(const render_scene *scene, const tree_node *root, const float *low,
                             const float *high, render_bvh *bvh)
{
    if (root->count == 0)
        return flatten(scene, root, 0, bvh);
    size_t at = bvh->node_count++;
    flatten_child(scene, root, low, high, 0, bvh, at, 0);
    uint32_t *node = bvh->nodes + 8 * at;
    memcpy(node + 3, node, 12);
    node[7] = RENDER_BVH_EMPTY;
    return (uint32_t)at;
}

static gpu_status build(const render_scene *scene, RTCDevice device, RTCBVH tree,
                        struct RTCBuildPrimitive *primitives, render_bvh *bvh)
{
    struct RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.maxDepth = RENDER_BVH_DEPTH - 4;
    arguments.maxLeafSize = LEAF_MOST;
    arguments.bvh = tree;
    arguments.primitives = primitives;
    arguments.primitiveCount = arguments.primitiveArrayCapacity = scene->triangle_count;
    arguments.createNode = make_inner;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = make_leaf;
    float low[3], high[3];
    bound(scene, primitives, low, high);
    lay_grid(bvh->nodes, low, high);
    const tree_node *root = rtcBuildBVH(&arguments);
    if (!root)
        return gpu_fail(GPU_FAILED, "Embree cannot build a tree of %zu triangles (error %d)",
                        scene->triangle_count, (int)rtcGetDeviceError(device));
    bvh->root = flatten_root(scene, root, low, high, bvh);
    return GPU_OK;
}

static gpu_status build_with_embree(const render_scene *scene, render_bvh *bvh)
{
    /* one thread: the order of what several find would differ from run to run */
    RTCDevice device = rtcNewDevice("threads=1");
    RTCBVH tree = device ? rtcNewBVH(device) : NULL;
    struct RTCBuildPrimitive *primitives =
        aligned_alloc(32, scene->triangle_count * sizeof *primitives);
    bvh->node_count = 1; /* the grid */
    bvh->nodes = malloc(8 * sizeof(uint32_t) * (scene->triangle_count + 1));
    bvh->triangles = malloc(12 * sizeof(float) * scene->triangle_count);
    gpu_status status;
    if (!tree)
        status = gpu_fail(GPU_FAILED, "Embree cannot be opened");
    else if (!primitives || !bvh->nodes || !bvh->triangles)
        status = gpu_fail(GPU_OUT_OF_MEMORY, "the tree of boxes: out of host memory");
    else
        status = build(scene, device, tree, primitives, bvh);
    free(primitives);
    if (tree)
        rtcReleaseBVH(tree);
    if (device)
        rtcReleaseDevice(device);
    return status;
}

#else

static gpu_status build_with_embree(const render_scene *scene, render_bvh *bvh)
{
    (void)scene, (void)bvh;
    return gpu_fail(GPU_UNSUPPORTED, "shadows need Embree, which this program was built without");
}

#endif

static gpu_status build_empty(render_bvh *bvh)
{
    bvh->nodes = calloc(16, sizeof *bvh->nodes);
    if (!bvh->nodes)
        return gpu_fail(GPU_OUT_OF_MEMORY, "the tree of boxes: out of host memory");
    bvh->nodes[14] = bvh->nodes[15] = RENDER_BVH_EMPTY;
    bvh->node_count = 2;
    bvh->root = bvh->depth = 1;
    return GPU_OK;
}

gpu_status render_bvh_build(const render_scene *scene, render_bvh *bvh)
{
    *bvh = (render_bvh){.root = RENDER_BVH_EMPTY};
    if (scene->triangle_count > RENDER_BVH_MOST)
        return gpu_fail(GPU_UNSUPPORTED, "shadows: %zu triangles are more than %d",
                        scene->triangle_count, RENDER_BVH_MOST);
    gpu_status status =
        scene->triangle_count == 0 ? build_empty(bvh) : build_with_embree(scene, bvh);
    if (status != GPU_OK)
        render_bvh_free(bvh);
    return status;
}

void render_bvh_free(render_bvh *bvh)
{
    free(bvh->nodes);
    free(bvh->triangles);
    *bvh = (render_bvh){.root = RENDER_BVH_EMPTY};
}
