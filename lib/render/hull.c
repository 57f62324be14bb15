/* The hull: its buffers, and its passes in their order; and the same near lights with upsampling in
 * the place of the hull. */
#include "hull_private.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

const hull_settings hull_standard = {
    .link_plane = 0.04F,
    .link_cosine = 0.3F,
    .split = 0.05F,
    .tau = 0.15F,
    .tau_width = 5,
    .near_pixels = 16,
    .merge = 0.002F,
};
const hull_settings hull_lobe_standard = {
    .kind = HULL_LOBES,
    .link_plane = 0.04F,
    .link_cosine = 0.5F,
    .split = 0.09F,
    .tau = 0.15F,
    .tau_width = 5,
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

/* list: ends with HULL_PASSES. */
static gpu_status create_list(render_frame *frame, hull *h, const hull_pass *list)
{
    gpu_status status = GPU_OK;
    for (; status == GPU_OK && *list != HULL_PASSES; list++)
        status = hull_create_pass(frame, h, *list);
    return status;
}

static gpu_status create_passes(render_frame *frame, hull *h)
{
    static const hull_pass shared[] = {HULL_TREE_IMAGE, HULL_MEAN_SAMPLES, HULL_MEAN_SUM,
                                       HULL_NEXT,       HULL_CULL_TILE,    HULL_CULL,
                                       HULL_NEAR,       HULL_EXACT,        HULL_PASSES};
    static const hull_pass moments[] = {HULL_LINKS,       HULL_COMPONENTS, HULL_CLAIM, HULL_GATHER,
                                        HULL_GATHER_EVEN, HULL_SPLIT,      HULL_PART,  HULL_SHARE,
                                        HULL_BLEND,       HULL_EMIT,       HULL_PASSES};
    static const hull_pass lobes[] = {HULL_LINKS,        HULL_COMPONENTS, HULL_CLAIM,
                                      HULL_GATHER_LOBES, HULL_FIT_LOBES,  HULL_SPLIT_LOBES,
                                      HULL_PART,         HULL_SHARE,      HULL_BLEND_LOBES,
                                      HULL_EMIT,         HULL_PASSES};
    const hull_pass upsample[] = {HULL_BOUNDS, h->push.tau > 0 ? HULL_GATHER_FAR : HULL_GATHER_ALL,
                                  HULL_UPSAMPLE_FAR, HULL_PASSES};
    gpu_status status = create_list(frame, h, shared);
    if (status == GPU_OK)
        status = create_list(frame, h,
                             h->kind == HULL_UPSAMPLE ? upsample
                             : h->kind == HULL_LOBES  ? lobes
                                                      : moments);
    if (status == GPU_OK && h->kind != HULL_UPSAMPLE)
        status = hull_create_draw(frame, h);
    return status;
}

/* Of an image of more pixels than usual less error is asked in proportion to their size: the
 * threshold of splitting and of near lights falls, and so does the angle that two neighbours of one
 * surface may enclose. Down to half, from where on the time that it takes is worth more. */
static float tolerance(const render_frame *frame)
{
    const float usual = 1280.0F * 720.0F, least = 0.5F;
    float pixels = (float)frame->width * (float)frame->height;
    return pixels > usual ? fmaxf(sqrtf(usual / pixels), least) : 1;
}

gpu_status hull_create(render_frame *frame, const hull_settings *settings, void **state)
{
    float share = tolerance(frame);
    *state = NULL;
    hull *h = calloc(1, sizeof *h);
    if (!h)
        return gpu_fail(GPU_OUT_OF_MEMORY, "the hull: out of host memory");
    uint32_t x = (frame->width + HULL_TILE - 1) / HULL_TILE;
    uint32_t y = (frame->height + HULL_TILE - 1) / HULL_TILE;
    h->tiles = x * y;
    h->blocks = 16 * h->tiles;
    h->kind = settings->kind;
    h->tau = share * settings->tau;
    h->push = (hull_push){.tiles_x = x,
                          .tiles_y = y,
                          .link_plane = settings->link_plane,
                          .link_cosine = cosf(share * acosf(settings->link_cosine)),
                          .split = share * settings->split,
                          .tau = h->tau,
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
    gpu_status status = hull_create_buffers(frame, h, settings);
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
    if (h->push.has_even) /* else no quad asks for it */
        hull_add_fill(l, "reset", HULL_B_EVEN_MAP, 0);
    hull_add_groups(l, "links", HULL_LINKS, (h->tiles * (HULL_TILE / HULL_ROWS) + 63) / 64);
    hull_add_groups(l, "components", HULL_COMPONENTS, (h->tiles + 7) / 8);
    add_near_lists(l);
    for (int level = 0; level < HULL_LEVELS; level++) {
        hull_add(l, "next", HULL_NEXT, level);
        hull_add_indirect(l, "claim", HULL_CLAIM, level, HULL_CLAIM_GROUPS);
        hull_add(l, "next", HULL_NEXT, level);
        hull_add_indirect(l, "gather", lobes ? HULL_GATHER_LOBES : HULL_GATHER, level,
                          HULL_GATHER_GROUPS);
        if (lobes)
            hull_add_indirect(l, "fit", HULL_FIT_LOBES, level, HULL_GATHER_GROUPS);
        else
            hull_add_indirect(l, "gather", HULL_GATHER_EVEN, level, HULL_EVEN_GROUPS);
        if (level > 0) {
            hull_add_indirect(l, "blend", HULL_SHARE, level, HULL_CLAIM_GROUPS);
            hull_add_indirect(l, "blend", lobes ? HULL_BLEND_LOBES : HULL_BLEND, level,
                              HULL_CLAIM_GROUPS);
        }
        hull_add_indirect(l, "split", lobes ? HULL_SPLIT_LOBES : HULL_SPLIT, level,
                          HULL_SPLIT_GROUPS);
        hull_add(l, "next", HULL_NEXT, level);
        hull_add_indirect(l, "split", HULL_PART, level, HULL_SPLIT_GROUPS);
    }
    hull_add(l, "next", HULL_NEXT, HULL_LEVELS);
    hull_add_indirect(l, "emit", HULL_EMIT, HULL_LEVELS, HULL_LEAF_GROUPS);
    hull_add(l, "next", HULL_NEXT, HULL_LEVELS + 1);
    hull_add_indirect(l, "emit", HULL_EMIT, HULL_LEVELS + 1, HULL_PLAIN_GROUPS);
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
    for (uint32_t i = 0; i <= HULL_LEVELS + 1; i++) {
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
