/* The hull: its buffers, and its passes in their order. */
#include "hull_private.h"

#include <stdlib.h>
#include <string.h>

const hull_settings hull_standard = {
    .link_plane = 0.01F,
    .link_cosine = 0.8F,
    .split = 0.05F,
    .tau = 0.05F,
    .tau_width = 4,
    .near_pixels = 16,
};

/* ---- What a pass is bound to -------------------------------------------------------------------
 */

/* Resources that are not buffers of the hull. */
enum { VIEW = HULL_BUFFERS, LIGHTS, COUNTERS, POSITION, NORMAL, LIGHT, END };

typedef struct pass_layout {
    const char *shader;
    int resources[12]; /* by binding, up to END */
} pass_layout;

static const pass_layout layouts[HULL_PASSES] = {
    [HULL_LINKS] = {"hull/links.comp",
                    {VIEW, POSITION, NORMAL, HULL_B_LINKS, HULL_B_ROW_BOUNDS, END}},
    [HULL_COMPONENTS] = {"hull/components.comp",
                         {VIEW, HULL_B_CONTROL, HULL_B_LINKS, HULL_B_MASKS, HULL_B_COMPONENTS,
                          HULL_B_ARGUMENTS, HULL_B_EXACT, HULL_B_QUADS, END}},
    [HULL_CLAIM] = {"hull/claim.comp",
                    {VIEW, HULL_B_CONTROL, HULL_B_LINKS, HULL_B_MASKS, HULL_B_MAP,
                     HULL_B_VERTEX_PIXELS, HULL_B_QUADS, END}},
    [HULL_MEAN_SAMPLES] = {"hull/mean.comp",
                           {VIEW, LIGHTS, COUNTERS, POSITION, NORMAL, HULL_B_SAMPLES, END}},
    [HULL_MEAN_SUM] = {"hull/mean_sum.comp", {VIEW, HULL_B_CONTROL, HULL_B_SAMPLES, END}},
    [HULL_NEXT] = {"hull/next.comp", {VIEW, HULL_B_CONTROL, COUNTERS, END}},
    [HULL_GATHER] = {"hull/gather.comp",
                     {VIEW, LIGHTS, COUNTERS, HULL_B_CONTROL, POSITION, NORMAL,
                      HULL_B_VERTEX_PIXELS, HULL_B_VERTICES, END}},
    [HULL_SPLIT] = {"hull/split.comp",
                    {VIEW, HULL_B_CONTROL, HULL_B_LINKS, HULL_B_MASKS, HULL_B_MAP, HULL_B_QUADS,
                     HULL_B_VERTICES, HULL_B_LEAVES, POSITION, NORMAL, END}},
    [HULL_EMIT] = {"hull/emit.comp",
                   {VIEW, HULL_B_CONTROL, HULL_B_LINKS, HULL_B_MASKS, HULL_B_MAP, HULL_B_QUADS,
                    HULL_B_LEAVES, HULL_B_CORNERS, HULL_B_ARGUMENTS, HULL_B_EXACT, END}},
    [HULL_CULL_TILE] = {"hull/cull_tile.comp",
                        {VIEW, LIGHTS, COUNTERS, HULL_B_CONTROL, HULL_B_ROW_BOUNDS,
                         HULL_B_BLOCK_BOUNDS, HULL_B_TILE_LISTS, END}},
    [HULL_CULL] = {"hull/cull.comp",
                   {VIEW, LIGHTS, COUNTERS, HULL_B_CONTROL, HULL_B_BLOCK_BOUNDS, HULL_B_TILE_LISTS,
                    HULL_B_NEAR_LISTS, HULL_B_NEAR_BLOCKS, END}},
    [HULL_NEAR] = {"hull/near.comp",
                   {VIEW, LIGHTS, COUNTERS, HULL_B_CONTROL, POSITION, NORMAL, LIGHT,
                    HULL_B_TILE_LISTS, HULL_B_NEAR_LISTS, HULL_B_NEAR_BLOCKS, END}},
    [HULL_EXACT] = {"upsample/exact.comp",
                    {VIEW, LIGHTS, COUNTERS, POSITION, NORMAL, LIGHT, HULL_B_ARGUMENTS,
                     HULL_B_EXACT, END}},
};

static int binding_kinds(const pass_layout *layout, gpu_binding *bindings)
{
    int count = 0;
    for (; layout->resources[count] != END; count++)
        bindings[count] = layout->resources[count] == POSITION || layout->resources[count] == NORMAL
                              ? GPU_FETCHED
                          : layout->resources[count] == LIGHT ? GPU_STORAGE_IMAGE
                                                              : GPU_STORAGE_BUFFER;
    return count;
}

static void *resource(const render_frame *frame, const hull *h, int which)
{
    switch (which) {
    case VIEW:
        return frame->view;
    case LIGHTS:
        return frame->lights;
    case COUNTERS:
        return frame->counters;
    case POSITION:
        return frame->position;
    case NORMAL:
        return frame->normal;
    case LIGHT:
        return frame->light;
    default:
        return h->buffers[which];
    }
}

/* ---- Making it ---------------------------------------------------------------------------------
 */

void hull_destroy(void *state)
{
    hull *h = state;
    if (!h)
        return;
    for (int i = 0; i < HULL_PASSES; i++)
        gpu_compute_destroy(h->passes[i]);
    gpu_draw_destroy(h->draw);
    for (int i = 0; i < HULL_BUFFERS; i++)
        gpu_buffer_destroy(h->buffers[i]);
    free(h);
}

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
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
    size_t lists = (frame->light_count + 1) * (size_t)h->tiles;
    const size_t bytes[HULL_BUFFERS] = {
        [HULL_B_CONTROL] = 4 * HULL_CONTROL_WORDS,
        [HULL_B_ARGUMENTS] = 16,
        [HULL_B_EXACT] = 4 * pixels,
        [HULL_B_LINKS] = 16 * HULL_TILE * tiles,
        [HULL_B_ROW_BOUNDS] = 128 * HULL_TILE * tiles,
        [HULL_B_MASKS] = 4 * HULL_TILE * HULL_MOST_COMPONENTS * tiles,
        [HULL_B_COMPONENTS] = 8 * HULL_MOST_COMPONENTS * tiles,
        [HULL_B_MAP] = 4 * pixels,
        [HULL_B_VERTEX_PIXELS] = 4 * vertices,
        [HULL_B_VERTICES] = HULL_VERTEX_BYTES * vertices,
        [HULL_B_QUADS] = 32 * quads,
        [HULL_B_LEAVES] = 4 * quads,
        [HULL_B_CORNERS] = least(16 * 3 * 4 * (quads / 2), most),
        [HULL_B_SAMPLES] = 8 * 32 * HULL_MEAN_ROWS,
        [HULL_B_BLOCK_BOUNDS] = 32 * (size_t)h->blocks,
        [HULL_B_TILE_LISTS] = 4 * lists,
        [HULL_B_NEAR_LISTS] = 4 * (HULL_MOST_NEAR + 1) * (size_t)h->blocks,
        [HULL_B_NEAR_BLOCKS] = 4 * (size_t)h->blocks,
    };
    for (int i = 0; i < HULL_BUFFERS; i++) {
        gpu_status status = gpu_buffer_create(frame->device, bytes[i], &h->buffers[i]);
        if (status != GPU_OK)
            return status;
    }
    return GPU_OK;
}

static gpu_status create_draw(render_frame *frame, hull *h)
{
    gpu_draw_options options = {
        .name = "hull",
        .vertex = render_shader("hull/hull.vert"),
        .fragment = render_shader("hull/hull.frag"),
        .binding_count = 6,
        .bindings = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_FETCHED,
                     GPU_FETCHED, GPU_STORAGE_BUFFER},
        .target_count = 1,
        .targets = {GPU_RGBA32F},
    };
    return gpu_draw_create(frame->device, &options, &h->draw);
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
    h->push = (hull_push){.tiles_x = x,
                          .tiles_y = y,
                          .link_plane = settings->link_plane,
                          .link_cosine = settings->link_cosine,
                          .split = settings->split,
                          .tau = settings->tau,
                          .tau_width = settings->tau_width,
                          .near_pixels = settings->near_pixels};
    gpu_status status = create_buffers(frame, h);
    for (int i = 0; status == GPU_OK && i < HULL_PASSES; i++) {
        gpu_binding bindings[GPU_MAX_BINDINGS];
        int count = binding_kinds(&layouts[i], bindings);
        status = render_compute(
            frame, layouts[i].shader, false, bindings, count,
            i == HULL_EXACT || i == HULL_MEAN_SAMPLES || i == HULL_MEAN_SUM ? 0 : sizeof(hull_push),
            &h->passes[i]);
    }
    if (status == GPU_OK)
        status = create_draw(frame, h);
    if (status == GPU_OK)
        *state = h;
    else
        hull_destroy(h);
    return status;
}

/* ---- Running it --------------------------------------------------------------------------------
 */

typedef struct list {
    const render_frame *frame;
    const hull *h;
    hull_push pushes[HULL_LEVELS + 1];
    gpu_step steps[48];
    int count;
} list;

static gpu_step *add(list *l, const char *name, hull_pass pass, int level)
{
    gpu_step *step = &l->steps[l->count++];
    *step = (gpu_step){.name = name, .compute = l->h->passes[pass], .push = &l->pushes[level]};
    for (int i = 0; layouts[pass].resources[i] != END; i++)
        step->resources[i] = resource(l->frame, l->h, layouts[pass].resources[i]);
    return step;
}

static void add_groups(list *l, const char *name, hull_pass pass, uint32_t groups)
{
    add(l, name, pass, 0)->groups[0] = groups;
}

static void add_indirect(list *l, const char *name, hull_pass pass, int level, int word)
{
    gpu_step *step = add(l, name, pass, level);
    step->indirect = l->h->buffers[pass == HULL_EXACT ? HULL_B_ARGUMENTS : HULL_B_CONTROL];
    step->indirect_offset = 4 * (size_t)word;
}

static void add_fill(list *l, const char *name, hull_buffer buffer, uint32_t bits)
{
    l->steps[l->count++] =
        (gpu_step){.name = name, .fill = l->h->buffers[buffer], .clear_bits = {bits}};
}

static void add_draw(list *l)
{
    const hull *h = l->h;
    const render_frame *f = l->frame;
    l->steps[l->count++] = (gpu_step){
        .name = "integrate",
        .draw = h->draw,
        .resources = {f->view, h->buffers[HULL_B_CORNERS], h->buffers[HULL_B_VERTICES], f->position,
                      f->normal, h->buffers[HULL_B_MASKS]},
        .indirect = h->buffers[HULL_B_CONTROL],
        .indirect_offset = 4 * HULL_DRAW,
        .targets = {f->light},
    };
}

gpu_status hull_run(render_frame *frame, void *state, render_statistics *statistics)
{
    const hull *h = state;
    list l = {.frame = frame, .h = h};
    for (uint32_t i = 0; i <= HULL_LEVELS; i++) {
        l.pushes[i] = h->push;
        l.pushes[i].level = i;
    }
    add_fill(&l, "reset", HULL_B_CONTROL, 0);
    add_fill(&l, "reset", HULL_B_ARGUMENTS, 1);
    add_fill(&l, "reset", HULL_B_MAP, 0);
    add_groups(&l, "links", HULL_LINKS, (h->tiles * HULL_TILE + 63) / 64);
    add_groups(&l, "components", HULL_COMPONENTS, (h->tiles + 7) / 8);
    add_groups(&l, "mean", HULL_MEAN_SAMPLES, HULL_MEAN_ROWS);
    add_groups(&l, "mean", HULL_MEAN_SUM, 1);
    for (int level = 0; level < HULL_LEVELS; level++) {
        add(&l, "next", HULL_NEXT, level);
        add_indirect(&l, "claim", HULL_CLAIM, level, HULL_CLAIM_GROUPS);
        add(&l, "next", HULL_NEXT, level);
        add_indirect(&l, "gather", HULL_GATHER, level, HULL_GATHER_GROUPS);
        add_indirect(&l, "split", HULL_SPLIT, level, HULL_SPLIT_GROUPS);
    }
    add_groups(&l, "cull", HULL_CULL_TILE, (h->tiles + 7) / 8);
    add_groups(&l, "cull", HULL_CULL, (h->blocks + 63) / 64);
    add(&l, "next", HULL_NEXT, HULL_LEVELS);
    add_indirect(&l, "emit", HULL_EMIT, 0, HULL_LEAF_GROUPS);
    add_draw(&l);
    add_indirect(&l, "near", HULL_NEAR, 0, HULL_NEAR_GROUPS);
    add_indirect(&l, "exact", HULL_EXACT, 0, 0);
    return render_run(frame, l.steps, l.count, statistics);
}

static gpu_status create_standard(render_frame *frame, void **state)
{
    return hull_create(frame, &hull_standard, state);
}

const render_pipeline hull_pipeline = {
    .id = "hull",
    .title = "a hull of vertices for the far light, near lights at every pixel",
    .create = create_standard,
    .run = hull_run,
    .destroy = hull_destroy,
};
