/* The buffers of the hull, and what finds room in them. */
#include "hull_private.h"

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

static uint32_t at_most(size_t count, uint32_t setting)
{
    return setting > 0 && setting < count ? setting : (uint32_t)count;
}

/* Quads of each level, so that two triangles for each of them always find room; how many. Every
 * component has its quad; further levels share what is left. */
static size_t place_quads(hull *h, size_t most, uint32_t setting)
{
    static const size_t a_tile[HULL_LEVELS] = {HULL_MOST_COMPONENTS, 64, 96, 128};
    size_t wanted = 0, tiles = h->tiles, quads = a_tile[0] * tiles;
    size_t left = most > quads ? most - quads : 0;
    h->push.quad_first[1] = (uint32_t)quads;
    for (int i = 1; i < HULL_LEVELS; i++)
        wanted += a_tile[i] * tiles;
    for (int i = 1; i < HULL_LEVELS; i++) {
        size_t count = a_tile[i] * tiles;
        count = wanted > left ? (size_t)((double)left * ((double)count / (double)wanted)) : count;
        quads += at_most(count, setting);
        h->push.quad_first[i + 1] = (uint32_t)quads;
    }
    return quads;
}

/* Storage buffers hold 128 MiB at most; see share_room in shaders/hull/next.comp for what does not
 * find room. */
gpu_status hull_create_buffers(render_frame *frame, hull *h, const hull_settings *settings)
{
    const size_t most = (size_t)128 << 20;
    size_t pixels = (size_t)frame->width * frame->height, tiles = h->tiles;
    size_t vertices = least(pixels / 6 + 4096, most / HULL_VERTEX_BYTES);
    size_t quads = place_quads(h, most / (6 * 16), settings->most_quads), corners = 6 * quads;
    h->push.vertex_capacity = at_most(vertices, settings->most_vertices);
    h->push.corner_capacity = at_most(corners, settings->most_corners);
    const size_t bytes[HULL_BUFFERS] = {
        [HULL_B_CONTROL] = 4 * HULL_CONTROL_WORDS,
        [HULL_B_ARGUMENTS] = 16,
        [HULL_B_EXACT] = 4 * pixels,
        [HULL_B_LINKS] = 16 * HULL_TILE * tiles,
        [HULL_B_ROW_BOUNDS] = 128 * (HULL_TILE / HULL_ROWS) * tiles,
        [HULL_B_MASKS] = 4 * HULL_TILE * HULL_MOST_COMPONENTS * tiles,
        [HULL_B_COMPONENTS] = 8 * HULL_MOST_COMPONENTS * tiles,
        [HULL_B_MAP] = 4 * pixels,
        [HULL_B_EVEN_MAP] = 4 * pixels,
        [HULL_B_VERTEX_PIXELS] = 4 * vertices,
        [HULL_B_VERTICES] = HULL_VERTEX_BYTES * vertices,
        [HULL_B_TILTED] = h->kind == HULL_LOBES ? 16 * vertices : 0,
        [HULL_B_SHARES] = 4 * vertices,
        [HULL_B_QUADS] = HULL_QUAD_BYTES * quads,
        [HULL_B_LEAVES] = 4 * quads,
        [HULL_B_CORNERS] = 16 * corners,
        [HULL_B_EVEN_CORNERS] = 16 * corners,
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
        if (bytes[i] == 0 || (h->kind == HULL_UPSAMPLE && !upsamples[i]))
            continue;
        gpu_status status = gpu_buffer_create(frame->device, bytes[i], &h->buffers[i]);
        if (status != GPU_OK)
            return status;
    }
    uint32_t rows = (2 * frame->light_count + LIGHT_NODES_ACROSS) / LIGHT_NODES_ACROSS;
    return gpu_image_create(frame->device, GPU_RGBA32U, LIGHT_NODE_TEXELS * LIGHT_NODES_ACROSS,
                            rows, &h->tree);
}
