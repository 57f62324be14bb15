// member.glsl: finding and claiming the vertices of a component. Needs hull.glsl, control.glsl and
// the buffers Links, Masks, Map, EvenMap, VertexPixels and Shares.
#ifndef MEMBER_GLSL
#define MEMBER_GLSL

#include "map.glsl"

bool bit(uint word, int at)
{
    return (word >> uint(at) & 1u) != 0u;
}

uvec4 row_links(ivec2 tile, int y)
{
    if (tile.x >= int(tiles_x) || tile.y >= int(tiles_y))
        return uvec4(0u);
    return links[(uint(tile.y) * tiles_x + uint(tile.x)) * uint(TILE) + uint(y)];
}

// Is this pixel of the tile part of the component? x and y may be 32: pixels of the next tiles
// belong to it if they are linked to one of its own.
bool is_member(uint component, ivec2 p)
{
    const int last = TILE - 1;
    ivec2 inner = min(p, ivec2(last));
    if (!bit(masks[component * uint(TILE) + uint(inner.y)], inner.x))
        return false;
    if (inner == p)
        return true;
    ivec2 tile = tile_origin(component) / TILE;
    uvec4 row = row_links(tile, inner.y);
    bool right = bit(row.y, inner.x), down = bit(row.z, inner.x);
    if (p.y < TILE)
        return right;
    if (p.x < TILE)
        return down;
    return (right && bit(row_links(tile + ivec2(1, 0), last).z, 0))
        || (down && bit(row_links(tile + ivec2(0, 1), 0).y, last));
}

// The member that is nearest to a place in the tile; of equally near ones the first.
ivec2 nearest_member(uint component, ivec2 p)
{
    if (is_member(component, p))
        return p;
    ivec2 best = p;
    int least = 0x7fffffff;
    uint to = uint(min(p.x, TILE - 1));
    for (int y = 0; y < TILE; y++) {
        uint m = masks[component * uint(TILE) + uint(y)];
        int left = findMSB(m & (0xffffffffu >> (31u - to))), right = findLSB(m & (0xffffffffu << to));
        int x = left >= 0 && (right < 0 || p.x - left <= right - p.x) ? left : right;
        int distance2 = (x - p.x) * (x - p.x) + (y - p.y) * (y - p.y);
        if (m != 0u && distance2 < least) {
            least = distance2;
            best = ivec2(x, y);
        }
    }
    return best;
}

#ifndef MEMBER_READ_ONLY
// Makes the member nearest to a place in the tile a vertex for quads of this kind, if it is not one
// yet. There is room: see share_room in next.comp.
uint claim_vertex(uint component, ivec2 p, bool even)
{
    uint pixel = pack_pixel(tile_origin(component) + nearest_member(component, p));
    uint at = map_index(pixel);
    uint slot = NONE;
    if (even) {
        if (even_map[at] == 0u && atomicCompSwap(even_map[at], 0u, NONE) == 0u) {
            slot = vertex_capacity - 1u - atomicAdd(even_count, 1u);
            even_map[at] = slot + 1u;
        }
    } else if (map[at] == 0u && atomicCompSwap(map[at], 0u, NONE) == 0u) {
        slot = atomicAdd(vertex_count, 1u);
        map[at] = slot + 1u;
    }
    if (slot != NONE) {
        vertex_pixels[slot] = pixel;
        shares[slot] = 0u;
    }
    return pixel;
}
#endif

// Does the component have a pixel in this part of its tile?
bool has_members(uint component, ivec2 p, ivec2 size)
{
    uint columns = (0xffffffffu >> (32 - size.x)) << p.x, any = 0u;
    for (int y = p.y; y < p.y + size.y; y++)
        any |= masks[component * uint(TILE) + uint(y)];
    return (any & columns) != 0u;
}

#endif
