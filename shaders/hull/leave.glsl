// leave.glsl: leaves pixels to be lit exactly. Needs hull.glsl and the buffers Masks, Arguments and Exact.
#ifndef LEAVE_GLSL
#define LEAVE_GLSL

// Those of a component in a part of its tile.
void leave_to_exact(uint component, ivec2 p, ivec2 size)
{
    ivec2 tile = tile_origin(component);
    uint columns = (NONE >> (TILE - size.x)) << p.x;
    for (int y = p.y; y < p.y + size.y; y++)
        for (uint m = masks[component * uint(TILE) + uint(y)] & columns; m != 0u; m &= m - 1u) {
            uint slot = atomicAdd(exact_count, 1u) - 1u;
            exact_pixels[slot] = uint(tile.y + y) * view.size.x + uint(tile.x + findLSB(m));
            atomicMax(exact_groups[0], slot / 64u + 1u);
        }
}

#endif
