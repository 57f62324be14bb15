/* The passes of the hull: what each is bound to, and lists of them. */
#include "hull_private.h"
#include "internal.h"

#include <stdlib.h>

/* Resources that are not buffers of the hull. */
enum {
    VIEW = HULL_BUFFERS,
    LIGHTS,
    COUNTERS,
    POSITION,
    NORMAL,
    LIGHT,
    TREE_IMAGE,
    TREE_STORED,
    END
};

typedef struct pass_layout {
    const char *shader;
    int resources[12]; /* by binding, up to END */
} pass_layout;

static const pass_layout layouts[HULL_PASSES] = {
    [HULL_TREE_IMAGE] = {"hull/tree_image.comp", {HULL_B_TREE, TREE_STORED, END}},
    [HULL_LINKS] = {"hull/links.comp",
                    {VIEW, POSITION, NORMAL, HULL_B_LINKS, HULL_B_ROW_BOUNDS, END}},
    [HULL_COMPONENTS] = {"hull/components.comp",
                         {VIEW, HULL_B_CONTROL, HULL_B_LINKS, HULL_B_MASKS, HULL_B_COMPONENTS,
                          HULL_B_ARGUMENTS, HULL_B_EXACT, HULL_B_QUADS, END}},
    [HULL_CLAIM] = {"hull/claim.comp",
                    {VIEW, HULL_B_CONTROL, HULL_B_LINKS, HULL_B_MASKS, HULL_B_MAP, HULL_B_EVEN_MAP,
                     HULL_B_VERTEX_PIXELS, HULL_B_QUADS, HULL_B_ARGUMENTS, HULL_B_EXACT,
                     HULL_B_SHARES, END}},
    [HULL_MEAN_SAMPLES] = {"hull/mean.comp",
                           {VIEW, TREE_IMAGE, COUNTERS, POSITION, NORMAL, HULL_B_SAMPLES, END}},
    [HULL_MEAN_SUM] = {"hull/mean_sum.comp", {VIEW, HULL_B_CONTROL, HULL_B_SAMPLES, END}},
    [HULL_NEXT] = {"hull/next.comp", {VIEW, HULL_B_CONTROL, COUNTERS, END}},
    [HULL_GATHER] = {"hull/gather.comp",
                     {VIEW, TREE_IMAGE, COUNTERS, HULL_B_CONTROL, POSITION, NORMAL,
                      HULL_B_VERTEX_PIXELS, HULL_B_VERTICES, END}},
    [HULL_GATHER_EVEN] = {"hull/gather_even.comp",
                          {VIEW, TREE_IMAGE, COUNTERS, HULL_B_CONTROL, POSITION, NORMAL,
                           HULL_B_VERTEX_PIXELS, HULL_B_VERTICES, END}},
    [HULL_SPLIT] = {"hull/split.comp",
                    {VIEW, HULL_B_CONTROL, HULL_B_LINKS, HULL_B_MASKS, HULL_B_MAP, HULL_B_EVEN_MAP,
                     HULL_B_QUADS, HULL_B_VERTICES, POSITION, NORMAL, END}},
    [HULL_PART] = {"hull/part.comp",
                   {VIEW, HULL_B_CONTROL, HULL_B_QUADS, HULL_B_LEAVES, HULL_B_MASKS,
                    HULL_B_ARGUMENTS, HULL_B_EXACT, END}},
    [HULL_SHARE] = {"hull/share.comp",
                    {VIEW, HULL_B_CONTROL, HULL_B_MAP, HULL_B_EVEN_MAP, HULL_B_QUADS, HULL_B_SHARES,
                     END}},
    [HULL_BLEND] = {"hull/blend.comp",
                    {VIEW, HULL_B_CONTROL, HULL_B_MAP, HULL_B_EVEN_MAP, HULL_B_QUADS, HULL_B_SHARES,
                     HULL_B_VERTICES, END}},
    [HULL_BLEND_LOBES] = {"hull/blend_lobe.comp",
                          {VIEW, HULL_B_CONTROL, HULL_B_MAP, HULL_B_EVEN_MAP, HULL_B_QUADS,
                           HULL_B_SHARES, HULL_B_VERTICES, END}},
    [HULL_EMIT] = {"hull/emit.comp",
                   {VIEW, HULL_B_CONTROL, HULL_B_LINKS, HULL_B_MASKS, HULL_B_MAP, HULL_B_EVEN_MAP,
                    HULL_B_QUADS, HULL_B_LEAVES, HULL_B_CORNERS, HULL_B_EVEN_CORNERS, END}},
    [HULL_CULL_TILE] = {"hull/cull_tile.comp",
                        {VIEW, TREE_IMAGE, COUNTERS, HULL_B_CONTROL, HULL_B_ROW_BOUNDS,
                         HULL_B_BLOCK_BOUNDS, HULL_B_TILE_LISTS, END}},
    [HULL_CULL] = {"hull/cull.comp",
                   {VIEW, TREE_IMAGE, COUNTERS, HULL_B_CONTROL, HULL_B_BLOCK_BOUNDS,
                    HULL_B_TILE_LISTS, HULL_B_NEAR_LISTS, HULL_B_NEAR_BLOCKS, END}},
    [HULL_NEAR] = {"hull/near.comp",
                   {VIEW, TREE_IMAGE, COUNTERS, HULL_B_CONTROL, POSITION, NORMAL, LIGHT,
                    HULL_B_NEAR_LISTS, HULL_B_NEAR_BLOCKS, END}},
    [HULL_GATHER_LOBES] = {"hull/gather_lobe.comp",
                           {VIEW, TREE_IMAGE, COUNTERS, HULL_B_CONTROL, POSITION, NORMAL,
                            HULL_B_VERTEX_PIXELS, HULL_B_VERTICES, HULL_B_TILTED, END}},
    [HULL_FIT_LOBES] = {"hull/fit_lobe.comp",
                        {VIEW, HULL_B_CONTROL, NORMAL, HULL_B_VERTEX_PIXELS, HULL_B_VERTICES,
                         HULL_B_TILTED, END}},
    [HULL_SPLIT_LOBES] = {"hull/split_lobe.comp",
                          {VIEW, HULL_B_CONTROL, HULL_B_LINKS, HULL_B_MASKS, HULL_B_MAP,
                           HULL_B_EVEN_MAP, HULL_B_QUADS, HULL_B_VERTICES, POSITION, NORMAL, END}},
    [HULL_BOUNDS] = {"upsample/bounds.comp", {VIEW, POSITION, HULL_B_ROW_BOUNDS, END}},
    [HULL_GATHER_FAR] = {"upsample/gather_far.comp",
                         {VIEW, TREE_IMAGE, COUNTERS, HULL_B_CONTROL, POSITION, NORMAL,
                          HULL_B_FAR_SAMPLES, END}},
    [HULL_GATHER_ALL] = {"upsample/gather_sh.comp",
                         {VIEW, LIGHTS, COUNTERS, HULL_B_CONTROL, POSITION, NORMAL,
                          HULL_B_FAR_SAMPLES, END}},
    [HULL_UPSAMPLE_FAR] = {"upsample/upsample_far.comp",
                           {VIEW, POSITION, NORMAL, LIGHT, HULL_B_FAR_SAMPLES, HULL_B_ARGUMENTS,
                            HULL_B_EXACT, END}},
    [HULL_EXACT] = {"hull/exact.comp",
                    {VIEW, TREE_IMAGE, COUNTERS, HULL_B_CONTROL, POSITION, NORMAL, LIGHT,
                     HULL_B_ARGUMENTS, HULL_B_EXACT, END}},
};

static gpu_binding kind_of(int which)
{
    switch (which) {
    case POSITION:
    case NORMAL:
    case TREE_IMAGE:
        return GPU_FETCHED;
    case LIGHT:
    case TREE_STORED:
        return GPU_STORAGE_IMAGE;
    default:
        return GPU_STORAGE_BUFFER;
    }
}

static int binding_kinds(const pass_layout *layout, gpu_binding *bindings)
{
    int count = 0;
    for (; layout->resources[count] != END; count++)
        bindings[count] = kind_of(layout->resources[count]);
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
    case TREE_IMAGE:
    case TREE_STORED:
        return h->tree;
    default:
        return h->buffers[which];
    }
}

gpu_status hull_create_pass(render_frame *frame, hull *h, hull_pass pass)
{
    gpu_binding bindings[GPU_MAX_BINDINGS];
    int count = binding_kinds(&layouts[pass], bindings);
    bool none = pass == HULL_MEAN_SUM || pass == HULL_TREE_IMAGE;
    bool method = pass == HULL_GATHER_LOBES || pass == HULL_FIT_LOBES || pass == HULL_SPLIT_LOBES;
    return render_compute(frame, layouts[pass].shader, method, bindings, count,
                          none ? 0 : sizeof(hull_push), &h->passes[pass]);
}

static void draw_options(bool lobes, gpu_draw_options *options)
{
    *options = (gpu_draw_options){
        .name = "hull",
        .vertex = render_shader(lobes ? "hull/hull_lobe.vert" : "hull/hull.vert"),
        .fragment = render_shader("hull/hull.frag"),
        .binding_count = 6,
        .bindings = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_FETCHED,
                     GPU_FETCHED, GPU_STORAGE_BUFFER},
        .target_count = 1,
        .targets = {GPU_RGBA32F},
    };
}

/* As hull_position in shaders/hull/position.glsl has it. */
static uint32_t viewport_side(uint32_t pixels)
{
    uint32_t side = 4096;
    while (side < pixels)
        side *= 2;
    return side;
}

static gpu_step draw_step(const render_frame *f, const hull *h)
{
    return (gpu_step){
        .name = "integrate",
        .draw = h->draw,
        .resources = {f->view, h->buffers[HULL_B_CORNERS], h->buffers[HULL_B_VERTICES], f->position,
                      f->normal, h->buffers[HULL_B_MASKS]},
        .indirect = h->buffers[HULL_B_CONTROL],
        .indirect_offset = 4 * HULL_DRAW,
        .targets = {f->light},
        .viewport = {viewport_side(f->width), viewport_side(f->height)},
    };
}

gpu_status hull_create_draw(render_frame *frame, hull *h)
{
    bool lobes = h->kind == HULL_LOBES;
    gpu_draw_options options;
    draw_options(lobes, &options);
    if (lobes) {
        gpu_status status =
            render_shader_method("hull/hull_lobe.frag", frame->options.method, &options.fragment);
        if (status != GPU_OK)
            return status;
    }
    gpu_status status = gpu_draw_create(frame->device, &options, &h->draw);
    if (lobes)
        free((char *)options.fragment.source);
    if (status != GPU_OK || lobes)
        return status;
    options.name = "hull/even";
    options.vertex = render_shader("hull/even.vert");
    options.fragment = render_shader("hull/even.frag");
    return gpu_draw_create(frame->device, &options, &h->draw_even);
}

/* What the last run drew, of the kind HULL_LOBES, once for each of a vertex's lobes. */
gpu_status hull_profile(render_frame *frame, void *state, float **points, size_t *count)
{
    gpu_draw_options options;
    draw_options(true, &options);
    options.name = "hull/profile";
    options.fragment = render_shader("hull/profile.frag");
    options.push_size = sizeof(int32_t);
    gpu_step step = draw_step(frame, state);
    gpu_status status = gpu_draw_create(frame->device, &options, &step.draw);
    if (status != GPU_OK)
        return status;
    status = profile_draw(frame, step, HULL_LOBE_COUNT, points, count);
    gpu_draw_destroy(step.draw);
    return status;
}

gpu_step *hull_add(hull_list *l, const char *name, hull_pass pass, int level)
{
    gpu_step *step = &l->steps[l->count++];
    *step = (gpu_step){.name = name, .compute = l->h->passes[pass], .push = &l->pushes[level]};
    for (int i = 0; layouts[pass].resources[i] != END; i++)
        step->resources[i] = resource(l->frame, l->h, layouts[pass].resources[i]);
    return step;
}

void hull_add_groups(hull_list *l, const char *name, hull_pass pass, uint32_t groups)
{
    hull_add(l, name, pass, 0)->groups[0] = groups;
}

void hull_add_indirect(hull_list *l, const char *name, hull_pass pass, int level, int word)
{
    gpu_step *step = hull_add(l, name, pass, level);
    step->indirect = l->h->buffers[pass == HULL_EXACT ? HULL_B_ARGUMENTS : HULL_B_CONTROL];
    step->indirect_offset = 4 * (size_t)word;
}

void hull_add_fill(hull_list *l, const char *name, hull_buffer buffer, uint32_t bits)
{
    l->steps[l->count++] =
        (gpu_step){.name = name, .fill = l->h->buffers[buffer], .clear_bits = {bits}};
}

void hull_add_draw(hull_list *l)
{
    l->steps[l->count++] = draw_step(l->frame, l->h);
    if (!l->h->draw_even)
        return;
    gpu_step *even = &l->steps[l->count++];
    *even = draw_step(l->frame, l->h);
    even->draw = l->h->draw_even;
    even->resources[1] = l->h->buffers[HULL_B_EVEN_CORNERS];
    even->indirect_offset = 4 * HULL_DRAW_EVEN;
    even->keep = true;
}
