#version 450
#extension GL_GOOGLE_include_directive : require
// components.comp: connected components of a tile by flooding rows of bits, one invocation a tile.
// The components come in the order of their first pixel, which is also their label; each begins as
// one quad. Single pixels, and what there are too many of, are left to be lit exactly. Rows are unrolled by macros: indexed arrays are slow in many compilers, and lavapipe
// ends a shader after 65,535 rounds of all its loops together.
#include "../common/frame.glsl"
#include "hull.glsl"
#include "control.glsl"

layout(local_size_x = 8) in;

layout(set = 0, binding = 2, std430) readonly buffer Links
{
    uvec4 links[];
};
layout(set = 0, binding = 3, std430) writeonly buffer Masks
{
    uint masks[]; // 32 rows a component
};
layout(set = 0, binding = 4, std430) writeonly buffer Components
{
    uvec2 components[]; // label, number of pixels; 0 of these: there is none
};
layout(set = 0, binding = 5, std430) buffer Arguments
{
    uint exact_groups[3];
    uint exact_count; // 1 more than there are
};
layout(set = 0, binding = 6, std430) writeonly buffer Exact
{
    uint exact_pixels[];
};
layout(set = 0, binding = 7, std430) writeonly buffer Quads
{
    Quad quads[];
};

#define EACH4(X, y) X(y) X(y + 1) X(y + 2) X(y + 3)
#define EACH8(X, y) EACH4(X, y) EACH4(X, y + 4)
#define EACH_ROW(X) EACH8(X, 0) EACH8(X, 8) EACH8(X, 16) EACH8(X, 24)
#define BACK4(X, y) X(y) X(y - 1) X(y - 2) X(y - 3)
#define BACK8(X, y) BACK4(X, y) BACK4(X, y - 4)
#define EACH_ROW_BACK(X) BACK8(X, 31) BACK8(X, 23) BACK8(X, 15) BACK8(X, 7)

// Spreads bits along a row; bit x of right: x is linked to x + 1.
uint flood(uint m, uint right)
{
    uint p = right << 1, q = right;
#define SPREAD(step)                                                                               \
    m |= (p & (m << step)) | (q & (m >> step));                                                    \
    p &= p << step;                                                                                \
    q &= q >> step;
    SPREAD(1) SPREAD(2) SPREAD(4) SPREAD(8) SPREAD(16)
    return m;
}

void main()
{
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= tiles_x * tiles_y)
        return;
    uint left[TILE], right[TILE], down[TILE], mask[TILE], unlike[TILE];
    uint rest[TILE]; // lit exactly; left: without a component yet
    uint gaps = 0u; // 0: every pixel is linked to the next, and every row to the one below
#define READ(Y)                                                                                    \
    {                                                                                              \
        uvec4 row = links[tile * uint(TILE) + uint(Y)];                                            \
        left[Y] = row.x;                                                                           \
        right[Y] = row.y & 0x7fffffffu;                                                            \
        down[Y] = Y < TILE - 1 ? row.z : 0u;                                                       \
        rest[Y] = 0u;                                                                              \
        unlike[Y] = row.w;                                                                         \
        gaps |= (right[Y] ^ 0x7fffffffu) | (Y < TILE - 1 && down[Y] == 0u ? 1u : 0u);              \
    }
    EACH_ROW(READ)
    uint count = 0u;
    ivec2 origin = TILE * ivec2(tile % tiles_x, tile / tiles_x);
    while (true) {
        uint seed = 0u, label = 0u;
#define SEED(Y)                                                                                    \
    mask[Y] = 0u;                                                                                  \
    if (seed == 0u && left[Y] != 0u) {                                                             \
        seed = left[Y] & (0u - left[Y]);                                                           \
        mask[Y] = seed;                                                                            \
        label = uint(origin.y + Y) * view.size.x + uint(origin.x + findLSB(seed));                 \
    }                                                                                              \
    mask[Y] = gaps == 0u ? left[Y] : mask[Y];
        EACH_ROW(SEED)
        if (seed == 0u)
            break;
        bool spreads = gaps != 0u;
        while (spreads) {
            spreads = false;
#define TAKE(Y)                                                                                    \
    {                                                                                              \
        uint m = mask[Y] | (mask[max(Y - 1, 0)] & down[max(Y - 1, 0)] & (Y > 0 ? NONE : 0u))       \
            | (mask[min(Y + 1, TILE - 1)] & down[Y]);                                              \
        m = flood(m, right[Y]);                                                                    \
        spreads = spreads || m != mask[Y];                                                         \
        mask[Y] = m;                                                                               \
    }
            EACH_ROW(TAKE)
            EACH_ROW_BACK(TAKE)
        }
        uint pixels = 0u, columns = 0u, uneven = 1u - has_even;
        int first = TILE, last = 0;
#define COUNT(Y)                                                                                   \
    pixels += uint(bitCount(mask[Y]));                                                             \
    columns |= mask[Y];                                                                            \
    uneven |= unlike[Y] & mask[Y]; /* by their neighbours */                                       \
    first = mask[Y] != 0u ? min(first, Y) : first;                                                 \
    last = mask[Y] != 0u ? Y : last;
        EACH_ROW(COUNT)
        bool keep = pixels > SMALL_COMPONENT && count < MOST_COMPONENTS;
        uint component = tile * MOST_COMPONENTS + count;
#define TAKE_OUT(Y)                                                                                \
    left[Y] &= ~mask[Y];                                                                           \
    rest[Y] |= keep ? 0u : mask[Y];                                                                \
    if (keep)                                                                                      \
        masks[component * uint(TILE) + uint(Y)] = mask[Y];
        EACH_ROW(TAKE_OUT)
        if (keep) {
            components[component] = uvec2(label, pixels);
            count++;
            uint at = atomicAdd(quad_count[0], 1u);
            quads[at].component = component;
            ivec2 low = ivec2(findLSB(columns), first) / STEP * STEP;
            ivec2 high = ivec2(findMSB(columns), last) / STEP * STEP + STEP;
            quads[at].origin = pack_pixel(origin + low);
            uint rank = uint(findMSB(pixels)); // of small ones are the pixels lit exactly
            quads[at].size = pack_pixel(high - low) | rank << 8 | (uneven == 0u ? EVEN_BIT : 0u);
            atomicAdd(wanted_vertices[rank], 5u);
        }
    }
    for (uint i = count; i < MOST_COMPONENTS; i++)
        components[tile * MOST_COMPONENTS + i] = uvec2(0u);

    uint pixels = 0u;
#define COUNT_REST(Y) pixels += uint(bitCount(rest[Y]));
    EACH_ROW(COUNT_REST)
    if (pixels == 0u)
        return;
    uint slot = atomicAdd(exact_count, pixels) - 1u;
    atomicMax(exact_groups[0], (slot + pixels + 63u) / 64u);
#define LEAVE(Y)                                                                                   \
    for (uint m = rest[Y]; m != 0u; m &= m - 1u)                                                   \
        exact_pixels[slot++] = uint(origin.y + Y) * view.size.x + uint(origin.x + findLSB(m));
    EACH_ROW(LEAVE)
}
