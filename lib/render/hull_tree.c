/* The tree over the lights: halved along what they differ in most. */
#include "hull_tree.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"

typedef struct ordered {
    double key;
    uint32_t index, from; /* of the light; of its emitter */
} ordered;

typedef struct builder {
    const light_data *lights;
    light_emitter *emitters, *scratch;
    ordered *order;
    light_node *nodes;
    size_t node_count;
} builder;

static double mean_exitance(const light_data *l)
{
    return ((double)l->a[3] + (double)l->b[3] + (double)l->c[3]) / 3;
}

/* ---- Halving ------------------------------------------------------------------------- */

static bool is_before(ordered a, ordered b)
{
    return a.key < b.key || (a.key == b.key && a.index < b.index);
}

/* Puts the first half before the second one. */
static void select_half(ordered *order, size_t count, size_t half)
{
    size_t low = 0, high = count - 1;
    while (low < high) {
        const ordered pivot = order[low + (high - low) / 2];
        size_t i = low, j = high;
        for (;;) {
            while (is_before(order[i], pivot))
                i++;
            while (is_before(pivot, order[j]))
                j--;
            if (i >= j)
                break;
            const ordered held = order[i];
            order[i++] = order[j];
            order[j--] = held;
        }
        if (half <= j) /* all up to j are no later than those past it */
            high = j;
        else
            low = j + 1;
    }
}

static void halve(builder *b, size_t first, size_t count)
{
    int widest = 0;
    double width = -1;
    for (int d = 0; d < LIGHT_DIMENSIONS; d++) {
        double low = DBL_MAX, high = -DBL_MAX;
        for (size_t i = first; i < first + count; i++) {
            low = fmin(low, b->emitters[i].place[d]);
            high = fmax(high, b->emitters[i].place[d]);
        }
        if (high - low > width) {
            width = high - low;
            widest = d;
        }
    }
    for (size_t i = 0; i < count; i++) {
        const light_emitter *e = &b->emitters[first + i];
        b->order[i] = (ordered){e->place[widest], e->index, (uint32_t)(first + i)};
    }
    select_half(b->order, count, (count + 1) / 2);
    for (size_t i = 0; i < count; i++)
        b->scratch[i] = b->emitters[b->order[i].from];
    memcpy(b->emitters + first, b->scratch, count * sizeof *b->scratch);
}

static void make_node(builder *b, size_t first, size_t count)
{
    size_t node = b->node_count++;
    light_node_make(b->lights, b->emitters + first, count, node % 2 == 0, &b->nodes[node]);
}

static void build(builder *b, size_t first, size_t count)
{
    size_t node = b->node_count;
    make_node(b, first, count);
    if (count > 1) {
        const size_t halves[2] = {(count + 1) / 2, count / 2};
        halve(b, first, count);
        for (int i = 0; i < 2; i++) {
            size_t at = first + (i ? halves[0] : 0), left = (halves[i] + 1) / 2;
            if (halves[i] > 1)
                halve(b, at, halves[i]);
            build(b, at, left);
            if (halves[i] > left)
                build(b, at + left, halves[i] - left);
        }
    }
    b->nodes[node].skip = (uint32_t)b->node_count;
}

/* ---- All of it ----------------------------------------------------------------------- */

/* A turn of a normal by 60 degrees weighs as much as the extent of all lights. */
static void read_emitters(builder *b, size_t count)
{
    double low[3] = {DBL_MAX, DBL_MAX, DBL_MAX}, high[3] = {-DBL_MAX, -DBL_MAX, -DBL_MAX};
    double extent = 0;
    for (size_t i = 0; i < count; i++) {
        light_emitter *e = &b->emitters[i];
        light_centre(&b->lights[i], e->place);
        e->index = (uint32_t)i;
        e->power = fmax(mean_exitance(&b->lights[i]), 0) * (double)b->lights[i].plane[3];
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], e->place[k]);
            high[k] = fmax(high[k], e->place[k]);
        }
    }
    for (int k = 0; k < 3; k++)
        extent = fmax(extent, high[k] - low[k]);
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            b->emitters[i].place[3 + k] = extent * (double)b->lights[i].plane[k];
}

size_t light_tree_build(const light_data *lights, size_t count, bool hierarchy, light_node *nodes)
{
    if (count == 0)
        return 0;
    builder b = {.lights = lights, .nodes = nodes};
    b.emitters = base_allocate(count * sizeof *b.emitters);
    b.scratch = base_allocate(count * sizeof *b.scratch);
    b.order = base_allocate(count * sizeof *b.order);
    read_emitters(&b, count);
    if (hierarchy)
        build(&b, 0, count);
    else
        for (size_t i = 0; i < count; i++) {
            make_node(&b, i, 1);
            nodes[i].skip = (uint32_t)i + 1;
        }
    free(b.emitters);
    free(b.scratch);
    free(b.order);
    return b.node_count;
}
