/* The hull: its buffers, and its passes in their order; and the same near lights with upsampling in
 * the place of the hull. */
#include "hull_private.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

const hull_settings hull_standard = {
    .link_plane = 0.04F,
    .link_cosine = 0.3F,
    .split = 0.08F,
    .tau = 0.2F,
    .tau_width = 3,
    .near_pixels = 16,
    .merge = 0.002F,
};
const hull_settings hull_lobe_standard = {
    .kind = HULL_LOBES,
    .link_plane = 0.04F,
    .link_cosine = 0.5F,
    .split = 0.15F,
    .tau = 0.2F,
    .tau_width = 3,
    .near_pixels = 16,
    .merge = 0.002F,
};

void hull_destroy(void *state)
{
    hull *h = state;
    if (!h)
        return;
    for (int i = 0; i < HULL_PASSES; i++)
        gpu_compute_destroy(h->passes[i]);
    gpu_draw_destroy(h->draw);
    gpu_draw_destroy(h->draw_even);
    for (int i = 0; i < HULL_BUFFERS; i++)
        gpu_buffer_destroy(h->buffers[i]);
    gpu_image_destroy(h->tree);
    free(h);
}

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Rows of pairs of blocks that are upsampled at once, of one more row of samples: all where these
 * find room in bytes. */
static size_t band_rows(const hull *h, size_t bytes)
{
    size_t row = HULL_SAMPLE_BYTES * (size_t)h->push.blocks_x;
    return row ? least((size_t)h->push.blocks_y + 1, bytes / row - 1) : 0;
}

/* Storage buffers hold 128 MiB at most; what does not find room is lit exactly. */
static gpu_status create_buffers(render_frame *frame, hull *h)
{
    const size_t most = (size_t)128 << 20;
    size_t pixels = (size_t)frame->width * frame->height, tiles = h->tiles;
    size_t vertices = least(pixels / 6 + 4096, most / HULL_VERTEX_BYTES);
    static const size_t quads_a_tile[HULL_LEVELS] = {HULL_MOST_COMPONENTS, 64, 96, 128};
    size_t quads = 0;
    for (int i = 0; i < HULL_LEVELS; i++) {
        h->push.quad_first[i] = (uint32_t)quads;
        quads += quads_a_tile[i] * tiles;
    }
    h->push.quad_first[HULL_LEVELS] = (uint32_t)quads;
    h->push.vertex_capacity = (uint32_t)vertices;
    const size_t bytes[HULL_BUFFERS] = {
        [HULL_B_CONTROL] = 4 * HULL_CONTROL_WORDS,
        [HULL_B_ARGUMENTS] = 16,
        [HULL_B_EXACT] = 4 * pixels,
        [HULL_B_LINKS] = 16 * HULL_TILE * tiles,
        [HULL_B_ROW_BOUNDS] = 128 * (HULL_TILE / HULL_ROWS) * tiles,
        [HULL_B_MASKS] = 4 * HULL_TILE * HULL_MOST_COMPONENTS * tiles,
        [HULL_B_COMPONENTS] = 8 * HULL_MOST_COMPONENTS * tiles,
        [HULL_B_MAP] = 4 * pixels,
        [HULL_B_VERTEX_PIXELS] = 4 * vertices,
        [HULL_B_VERTICES] = HULL_VERTEX_BYTES * vertices,
        [HULL_B_QUADS] = 32 * quads,
        [HULL_B_LEAVES] = 4 * quads,
        [HULL_B_CORNERS] = least(16 * 3 * 4 * (quads / 2), most),
        [HULL_B_EVEN_CORNERS] = least(16 * 3 * 4 * (quads / 2), most),
        [HULL_B_SAMPLES] = 8 * 32 * HULL_MEAN_ROWS,
        [HULL_B_BLOCK_BOUNDS] = 32 * (size_t)h->blocks,
        [HULL_B_TILE_LISTS] = 4 * (HULL_MOST_TILE + 1) * tiles,
        [HULL_B_NEAR_LISTS] = 4 * (HULL_MOST_NEAR + 1) * (size_t)h->blocks,
        [HULL_B_NEAR_BLOCKS] = 4 * (size_t)h->blocks,
        [HULL_B_FAR_SAMPLES] =
            HULL_SAMPLE_BYTES * (size_t)h->push.blocks_x * (band_rows(h, most) + 1),
        [HULL_B_TREE] = sizeof(light_node) * (2 * (size_t)frame->light_count + 1),
    };
    static const bool upsamples[HULL_BUFFERS] = {
        [HULL_B_CONTROL] = true,     [HULL_B_ARGUMENTS] = true,  [HULL_B_EXACT] = true,
        [HULL_B_ROW_BOUNDS] = true,  [HULL_B_SAMPLES] = true,    [HULL_B_BLOCK_BOUNDS] = true,
        [HULL_B_TILE_LISTS] = true,  [HULL_B_NEAR_LISTS] = true, [HULL_B_NEAR_BLOCKS] = true,
        [HULL_B_FAR_SAMPLES] = true, [HULL_B_TREE] = true,
    };
    for (int i = 0; i < HULL_BUFFERS; i++) {
        if (h->kind == HULL_UPSAMPLE && !upsamples[i])
            continue;
        gpu_status status = gpu_buffer_create(frame->device, bytes[i], &h->buffers[i]);
        if (status != GPU_OK)
            return status;
    }
    uint32_t rows = (2 * frame->light_count + LIGHT_NODES_ACROSS) / LIGHT_NODES_ACROSS;
    return gpu_image_create(frame->device, GPU_RGBA32U, LIGHT_NODE_TEXELS * LIGHT_NODES_ACROSS,
                            rows, &h->tree);
}

static gpu_status create_passes(render_frame *frame, hull *h)
{
    static const hull_pass shared[] = {HULL_TREE_IMAGE, HULL_MEAN_SAMPLES, HULL_MEAN_SUM,
                                       HULL_NEXT,       HULL_CULL_TILE,    HULL_CULL,
                                       HULL_NEAR,       HULL_EXACT};
    static const hull_pass moments[] = {HULL_LINKS,  HULL_COMPONENTS, HULL_CLAIM,
                                        HULL_GATHER, HULL_SPLIT,      HULL_EMIT};
    static const hull_pass lobes[] = {HULL_LINKS,        HULL_COMPONENTS,  HULL_CLAIM,
                                      HULL_GATHER_LOBES, HULL_SPLIT_LOBES, HULL_EMIT};
    const hull_pass upsample[] = {HULL_BOUNDS, h->push.tau > 0 ? HULL_GATHER_FAR : HULL_GATHER_ALL,
                                  HULL_UPSAMPLE_FAR};
    const hull_pass *own = h->kind == HULL_UPSAMPLE ? upsample
                           : h->kind == HULL_LOBES  ? lobes
                                                    : moments;
    int own_count = h->kind == HULL_UPSAMPLE ? 3 : 6;
    gpu_status status = GPU_OK;
    for (int i = 0; status == GPU_OK && i < 8; i++)
        status = hull_create_pass(frame, h, shared[i]);
    for (int i = 0; status == GPU_OK && i < own_count; i++)
        status = hull_create_pass(frame, h, own[i]);
    if (status == GPU_OK && h->kind != HULL_UPSAMPLE)
        status = hull_create_draw(frame, h);
    return status;
}

gpu_status hull_create(render_frame *frame, const hull_settings *settings, void **state)
{
    *state = NULL;
    hull *h = calloc(1, sizeof *h);
    if (!h)
        return gpu_fail(GPU_OUT_OF_MEMORY, "the hull: out of host memory");
    uint32_t x = (frame->width + HULL_TILE - 1) / HULL_TILE;
    uint32_t y = (frame->height + HULL_TILE - 1) / HULL_TILE;
    h->tiles = x * y;
    h->blocks = 16 * h->tiles;
    h->kind = settings->kind;
    h->tau = settings->tau;
    h->push = (hull_push){.tiles_x = x,
                          .tiles_y = y,
                          .link_plane = settings->link_plane,
                          .link_cosine = settings->link_cosine,
                          .split = settings->split,
                          .tau = settings->tau,
                          .tau_width = settings->tau_width,
                          .near_pixels = settings->near_pixels,
                          .plane = settings->plane,
                          .power = settings->power,
                          .least = settings->least,
                          .has_even = settings->kind == HULL_MOMENTS,
                          .merge = settings->merge};
    if (h->kind == HULL_UPSAMPLE) {
        h->push.factor = settings->factor;
        h->push.blocks_x = (frame->width + settings->factor - 1) / settings->factor;
        h->push.blocks_y = (frame->height + settings->factor - 1) / settings->factor;
    }
    gpu_status status = create_buffers(frame, h);
    if (status == GPU_OK)
        status = create_passes(frame, h);
    if (status == GPU_OK)
        *state = h;
    else
        hull_destroy(h);
    return status;
}

static void add_near_lists(hull_list *l)
{
    hull_add_groups(l, "mean", HULL_MEAN_SAMPLES, HULL_MEAN_ROWS);
    hull_add_groups(l, "mean", HULL_MEAN_SUM, 1);
    hull_add_groups(l, "cull", HULL_CULL_TILE, (l->h->tiles + 7) / 8);
    hull_add_groups(l, "cull", HULL_CULL, (l->h->blocks + 63) / 64);
}

/* The far light by the hull. */
static void add_hull(hull_list *l)
{
    const hull *h = l->h;
    bool lobes = h->kind == HULL_LOBES;
    hull_add_fill(l, "reset", HULL_B_MAP, 0);
    hull_add_groups(l, "links", HULL_LINKS, (h->tiles * (HULL_TILE / HULL_ROWS) + 63) / 64);
    hull_add_groups(l, "components", HULL_COMPONENTS, (h->tiles + 7) / 8);
    add_near_lists(l);
    for (int level = 0; level < HULL_LEVELS; level++) {
        hull_add(l, "next", HULL_NEXT, level);
        hull_add_indirect(l, "claim", HULL_CLAIM, level, HULL_CLAIM_GROUPS);
        hull_add(l, "next", HULL_NEXT, level);
        hull_add_indirect(l, "gather", lobes ? HULL_GATHER_LOBES : HULL_GATHER, level,
                          HULL_GATHER_GROUPS);
        hull_add_indirect(l, "split", lobes ? HULL_SPLIT_LOBES : HULL_SPLIT, level,
                          HULL_SPLIT_GROUPS);
    }
    hull_add(l, "next", HULL_NEXT, HULL_LEVELS);
    hull_add_indirect(l, "emit", HULL_EMIT, 0, HULL_LEAF_GROUPS);
    hull_add_draw(l);
}

/* The light, or the far light, by upsampling. */
static void add_upsampling(hull_list *l)
{
    const hull *h = l->h;
    if (h->push.tau > 0) {
        hull_add_groups(l, "bounds", HULL_BOUNDS,
                        (4 * (HULL_TILE / HULL_ROWS) * h->tiles + 63) / 64);
        add_near_lists(l);
        hull_add(l, "next", HULL_NEXT, HULL_LEVELS);
    }
    hull_pass gather = h->push.tau > 0 ? HULL_GATHER_FAR : HULL_GATHER_ALL;
    /* bands are numbered by the push's level */
    uint32_t across = h->push.blocks_x,
             rows = (uint32_t)(gpu_buffer_size(h->buffers[HULL_B_FAR_SAMPLES]) / HULL_SAMPLE_BYTES /
                               across) -
                    1;
    for (uint32_t band = 0; band * rows <= h->push.blocks_y; band++) {
        hull_add(l, "gather", gather, (int)band)->groups[0] = (across * (rows + 1) + 63) / 64;
        gpu_step *step = hull_add(l, "upsample", HULL_UPSAMPLE_FAR, (int)band);
        step->groups[0] = (l->frame->width + 63) / 64;
        step->groups[1] = rows;
    }
}

/* The errors of many small lights add up: a quarter of tau for 16 times as many keeps the sum. */
static float tau_for(const hull *h, uint32_t lights)
{
    const float usual = 256;
    return (float)lights > usual ? h->tau * sqrtf(usual / (float)lights) : h->tau;
}

/* On the host, which has made the lights. */
static void build_tree(render_frame *frame, hull *h, render_statistics *statistics)
{
    struct timespec begun, ended;
    h->push.tau = tau_for(h, frame->light_count);
    clock_gettime(CLOCK_MONOTONIC, &begun);
    h->push.nodes_end = (uint32_t)light_tree_build(
        gpu_buffer_map(frame->lights), frame->light_count, h->push.merge > 0 && h->tau > 0,
        gpu_buffer_map(h->buffers[HULL_B_TREE]));
    clock_gettime(CLOCK_MONOTONIC, &ended);
    statistics_add_time(statistics, "tree",
                        1e3 * (double)(ended.tv_sec - begun.tv_sec) +
                            1e-6 * (double)(ended.tv_nsec - begun.tv_nsec));
}

gpu_status hull_run(render_frame *frame, void *state, render_statistics *statistics)
{
    hull *h = state;
    build_tree(frame, h, statistics);
    hull_list l = {.frame = frame, .h = h};
    for (uint32_t i = 0; i <= HULL_LEVELS; i++) {
        l.pushes[i] = h->push;
        l.pushes[i].level = i;
    }
    hull_add_fill(&l, "reset", HULL_B_CONTROL, 0);
    hull_add_fill(&l, "reset", HULL_B_ARGUMENTS, 1);
    hull_add_groups(&l, "tree", HULL_TREE_IMAGE, (LIGHT_NODE_TEXELS * h->push.nodes_end + 63) / 64);
    if (h->kind == HULL_UPSAMPLE)
        add_upsampling(&l);
    else
        add_hull(&l);
    if (h->push.tau > 0)
        hull_add_indirect(&l, "near", HULL_NEAR, 0, HULL_NEAR_GROUPS);
    hull_add_indirect(&l, "exact", HULL_EXACT, 0, 0);
    return render_run(frame, l.steps, l.count, statistics);
}

#define HULL(NAME, TITLE, PROFILE)                                                                 \
    static gpu_status create_##NAME(render_frame *frame, void **state)                             \
    {                                                                                              \
        return hull_create(frame, &NAME##_standard, state);                                        \
    }                                                                                              \
    HULL_PIPELINE(NAME, TITLE, PROFILE)

HULL(hull, "a hull of vertices for the far light, near lights at every pixel", NULL)
HULL(hull_lobe, "the same with lobes at each vertex, integrated by the fitted form", hull_profile)
