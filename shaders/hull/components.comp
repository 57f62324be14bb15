#version 450
#extension GL_GOOGLE_include_directive : require
// components.comp: connected components of a tile by flooding rows of bits, one invocation a tile.
// The components come in the order of their first pixel, which is also their label. Small ones are
// left to be lit exactly, as they would have about as many vertices as pixels.
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
layout(set = 0, binding = 7, std430) writeonly buffer Seeds
{
    uint seeds[]; // components that begin as a quad
};

// Spreads bits along a row; bit x of right: x is linked to x + 1.
uint flood(uint m, uint right)
{
    uint p = right << 1, q = right;
    for (int step = 1; step < 32; step <<= 1) {
        m |= (p & (m << step)) | (q & (m >> step));
        p &= p << step;
        q &= q >> step;
    }
    return m;
}

void main()
{
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= tiles_x * tiles_y)
        return;
    uint surface[TILE], right[TILE], down[TILE], mask[TILE];
    uint gaps = 0u; // 0: every pixel is linked to the next, and every row to the one below
    for (int y = 0; y < TILE; y++) {
        uvec4 row = links[tile * uint(TILE) + uint(y)];
        surface[y] = row.x;
        right[y] = row.y & 0x7fffffffu;
        down[y] = y < TILE - 1 ? row.z : 0u;
        gaps |= right[y] ^ 0x7fffffffu | (y < TILE - 1 && down[y] == 0u ? 1u : 0u);
    }
    uint count = 0u;
    ivec2 origin = TILE * ivec2(tile % tiles_x, tile / tiles_x);
    for (int first = 0; first < TILE;) {
        if (surface[first] == 0u) {
            first++;
            continue;
        }
        for (int y = 0; y < TILE; y++)
            mask[y] = gaps == 0u ? surface[y] : 0u;
        uint seed = surface[first] & -surface[first];
        mask[first] |= seed;
        bool spreads = gaps != 0u;
        while (spreads) {
            spreads = false;
            for (int i = first; i < 2 * TILE - first; i++) { // down, then up
                int y = i < TILE ? i : 2 * TILE - 1 - i;
                uint m = mask[y];
                m |= y > 0 ? mask[y - 1] & down[y - 1] : 0u;
                m |= y < TILE - 1 ? mask[y + 1] & down[y] : 0u;
                m = flood(m, right[y]);
                spreads = spreads || m != mask[y];
                mask[y] = m;
            }
        }
        uint pixels = 0u;
        for (int y = first; y < TILE; y++) {
            pixels += uint(bitCount(mask[y]));
            surface[y] &= ~mask[y];
        }
        bool keep = pixels > SMALL_COMPONENT && count < MOST_COMPONENTS;
        if (keep) {
            uint component = tile * MOST_COMPONENTS + count++;
            for (int y = 0; y < TILE; y++)
                masks[component * uint(TILE) + uint(y)] = mask[y];
            components[component] = uvec2(
                uint(origin.y + first) * view.size.x + uint(origin.x + findLSB(seed)), pixels);
            seeds[atomicAdd(seed_count, 1u)] = component;
        } else {
            uint slot = atomicAdd(exact_count, pixels) - 1u;
            atomicMax(exact_groups[0], (slot + pixels + 63u) / 64u);
            for (int y = first; y < TILE; y++)
                for (uint m = mask[y]; m != 0u; m &= m - 1u)
                    exact_pixels[slot++] =
                        uint(origin.y + y) * view.size.x + uint(origin.x + findLSB(m));
        }
    }
    for (; count < MOST_COMPONENTS; count++)
        components[tile * MOST_COMPONENTS + count] = uvec2(0u);
}
