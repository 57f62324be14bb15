/* The tree of boxes: Embree builds it, in nodes of its own making; then it is laid out depth first,
 * so that a subtree lies together. */
#include "bvh.h"

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

static void bound(const render_scene *scene, struct RTCBuildPrimitive *primitives)
{
    for (uint32_t t = 0; t < scene->triangle_count; t++) {
        float low[3], high[3];
        memcpy(low, corner(scene, t, 0), sizeof low);
        memcpy(high, low, sizeof high);
        for (int i = 1; i < 3; i++)
            for (int k = 0; k < 3; k++) {
                float x = corner(scene, t, i)[k];
                low[k] = x < low[k] ? x : low[k];
                high[k] = x > high[k] ? x : high[k];
            }
        primitives[t] =
            (struct RTCBuildPrimitive){low[0], low[1], low[2], 0, high[0], high[1], high[2], t};
    }
}

static void put_word(float *to, uint32_t word)
{
    memcpy(to, &word, sizeof word);
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

/* Recursion as deep as the tree: RENDER_BVH_DEPTH at most. */
static uint32_t flatten(const render_scene *scene, const tree_node *node, uint32_t depth,
                        render_bvh *bvh)
{
    if (node->count > 0)
        return flatten_leaf(scene, node, bvh);
    uint32_t at = (uint32_t)bvh->node_count++;
    if (depth + 1 > bvh->depth)
        bvh->depth = depth + 1;
    float *to = bvh->nodes + 16 * (size_t)at;
    for (int i = 0; i < 2; i++) {
        memcpy(to + 8 * i, node->low[i], 12);
        memcpy(to + 8 * i + 4, node->high[i], 12);
    }
    put_word(to + 11, 0);
    put_word(to + 15, 0);
    put_word(to + 3, flatten(scene, node->child[0], depth + 1, bvh));
    put_word(to + 7, flatten(scene, node->child[1], depth + 1, bvh));
    return at;
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
    bound(scene, primitives);
    const tree_node *root = rtcBuildBVH(&arguments);
    if (!root)
        return gpu_fail(GPU_FAILED, "Embree cannot build a tree of %zu triangles (error %d)",
                        scene->triangle_count, (int)rtcGetDeviceError(device));
    bvh->root = flatten(scene, root, 0, bvh);
    return GPU_OK;
}

static gpu_status build_with_embree(const render_scene *scene, render_bvh *bvh)
{
    /* one thread: the order of what several find would differ from run to run */
    RTCDevice device = rtcNewDevice("threads=1");
    RTCBVH tree = device ? rtcNewBVH(device) : NULL;
    struct RTCBuildPrimitive *primitives =
        aligned_alloc(32, scene->triangle_count * sizeof *primitives);
    bvh->nodes = malloc(16 * sizeof(float) * scene->triangle_count);
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

gpu_status render_bvh_build(const render_scene *scene, render_bvh *bvh)
{
    *bvh = (render_bvh){.root = RENDER_BVH_EMPTY};
    if (scene->triangle_count > RENDER_BVH_MOST)
        return gpu_fail(GPU_UNSUPPORTED, "shadows: %zu triangles are more than %d",
                        scene->triangle_count, RENDER_BVH_MOST);
    if (scene->triangle_count == 0)
        return GPU_OK;
    gpu_status status = build_with_embree(scene, bvh);
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
