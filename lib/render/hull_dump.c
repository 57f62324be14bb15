/* A picture of every stage of the hull: components, triangles with their vertices, near lights. */
#include "hull_private.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/file.h"
#include "canvas.h"

typedef struct stages {
    int width, height;
    const render_frame *frame;
    const hull *h;
    const uint32_t *control;
    float *depth;
} stages;

static uint32_t capped(uint32_t count, const gpu_buffer *buffer, size_t item)
{
    size_t most = gpu_buffer_size(buffer) / item;
    return count < most ? count : (uint32_t)most;
}

/* Components in colours; what is lit exactly in white. */
static bool draw_components(const stages *s, const char *folder)
{
    const uint32_t *masks = gpu_buffer_map(s->h->buffers[HULL_B_MASKS]);
    const uint32_t *components = gpu_buffer_map(s->h->buffers[HULL_B_COMPONENTS]);
    const uint32_t *exact = gpu_buffer_map(s->h->buffers[HULL_B_EXACT]);
    const uint32_t *arguments = gpu_buffer_map(s->h->buffers[HULL_B_ARGUMENTS]);
    canvas c = canvas_open(s->width, s->height);
    for (uint32_t i = 0; i < s->h->tiles * HULL_MOST_COMPONENTS; i++) {
        if (components[2 * i + 1] == 0)
            continue;
        uint32_t tile = i / HULL_MOST_COMPONENTS;
        int left = (int)(tile % s->h->push.tiles_x) * HULL_TILE;
        int top = (int)(tile / s->h->push.tiles_x) * HULL_TILE;
        for (int y = 0; y < HULL_TILE; y++)
            for (int x = 0; x < HULL_TILE; x++)
                if (masks[i * HULL_TILE + (uint32_t)y] >> x & 1)
                    canvas_set(&c, left + x, top + y, canvas_number(components[2 * i]));
    }
    uint32_t count = capped(arguments[3], s->h->buffers[HULL_B_EXACT], 4);
    for (uint32_t i = 0; i + 1 < count; i++)
        canvas_set(&c, (int)(exact[i] % s->frame->width), (int)(exact[i] / s->frame->width),
                   (canvas_color){255, 255, 255});
    bool done = canvas_write(&c, folder, "components.png");
    canvas_close(&c);
    return done;
}

/* One of the two lists of triangles. */
static void draw_list(const stages *s, hull_buffer buffer, int count_word, canvas_color color,
                      canvas *c)
{
    const uint32_t *corners = gpu_buffer_map(s->h->buffers[buffer]);
    uint32_t count = capped(s->control[count_word], s->h->buffers[buffer], 16);
    for (uint32_t i = 0; i + 2 < count; i += 3)
        for (uint32_t j = 0; j < 3; j++) {
            uint32_t from = corners[4 * (i + j) + 1], to = corners[4 * (i + (j + 1) % 3) + 1];
            canvas_line(c, (int)(from & 0xffff), (int)(from >> 16), (int)(to & 0xffff),
                        (int)(to >> 16), color);
        }
}

/* The triangles of the hull on the depth, those with one normal all over in green, and the pixels
 * where light was gathered. */
static bool draw_triangles(const stages *s, const char *folder)
{
    const uint32_t *pixels = gpu_buffer_map(s->h->buffers[HULL_B_VERTEX_PIXELS]);
    canvas c = canvas_open(s->width, s->height);
    canvas_depth(&c, s->depth, (size_t)s->width * (size_t)s->height);
    draw_list(s, HULL_B_CORNERS, HULL_DRAW, (canvas_color){60, 130, 230}, &c);
    draw_list(s, HULL_B_EVEN_CORNERS, HULL_DRAW_EVEN, (canvas_color){70, 190, 90}, &c);
    uint32_t most = s->h->push.vertex_capacity; /* see map.glsl */
    for (uint32_t i = 0; i < most; i++)
        if (i < s->control[HULL_VERTEX_COUNT] || most - i <= s->control[HULL_EVEN_COUNT])
            canvas_set(&c, (int)(pixels[i] & 0xffff), (int)(pixels[i] >> 16),
                       (canvas_color){255, 210, 40});
    bool done = canvas_write(&c, folder, "triangles.png");
    canvas_close(&c);
    return done;
}

/* How many lights may be near to a block, up to 32. */
static bool draw_near(const stages *s, const char *folder)
{
    const uint32_t *blocks = gpu_buffer_map(s->h->buffers[HULL_B_NEAR_BLOCKS]);
    const uint32_t *lists = gpu_buffer_map(s->h->buffers[HULL_B_NEAR_LISTS]);
    const uint32_t across = HULL_TILE / HULL_BLOCK;
    canvas c = canvas_open(s->width, s->height);
    for (uint32_t i = 0; i < s->control[HULL_NEAR_COUNT]; i++) {
        uint32_t tile = blocks[i] / (across * across), place = blocks[i] % (across * across);
        int left = (int)(tile % s->h->push.tiles_x * HULL_TILE + place % across * HULL_BLOCK);
        int top = (int)(tile / s->h->push.tiles_x * HULL_TILE + place / across * HULL_BLOCK);
        canvas_color color = canvas_scale(lists[blocks[i] * (HULL_MOST_NEAR + 1)] / 32.0);
        for (int y = 0; y < HULL_BLOCK; y++)
            for (int x = 0; x < HULL_BLOCK; x++)
                canvas_set(&c, left + x, top + y, color);
    }
    bool done = canvas_write(&c, folder, "near.png");
    canvas_close(&c);
    return done;
}

bool hull_dump(render_frame *frame, void *state, const char *folder)
{
    stages s = {
        .width = (int)frame->width, .height = (int)frame->height, .frame = frame, .h = state};
    s.control = gpu_buffer_map(s.h->buffers[HULL_B_CONTROL]);
    s.depth = malloc((size_t)frame->width * frame->height * sizeof *s.depth);
    bool done = base_make_directory(folder);
    if (done && (!s.depth || gpu_image_read(frame->depth, s.depth) != GPU_OK)) {
        fprintf(stderr, "sgfit: %s\n", s.depth ? gpu_last_error() : "out of memory");
        done = false;
    }
    done = done && (s.h->kind == HULL_UPSAMPLE ||
                    (draw_components(&s, folder) && draw_triangles(&s, folder)));
    done = done && (s.h->push.tau <= 0 || draw_near(&s, folder));
    free(s.depth);
    return done;
}
