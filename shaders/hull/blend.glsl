// blend.glsl: vertices come gradually. Where a quad's error has just passed what splits it, the new
// vertices of its parts are mostly what the quad would interpolate in their place, and all their own
// with three times that error: a quad that splits in one frame and not in the next does not flicker. A
// vertex that several quads want follows the one that has most of its own, told by a key of its share.
#include "../common/frame.glsl"
#include "hull.glsl"
#include "control.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 2, std430) readonly buffer Map
{
    uint map[];
};
layout(set = 0, binding = 3, std430) readonly buffer EvenMap
{
    uint even_map[];
};
layout(set = 0, binding = 4, std430) readonly buffer Quads
{
    Quad quads[];
};
layout(set = 0, binding = 5, std430) buffer Shares
{
    uint shares[]; // the greatest key of a vertex; 0: it is done, or none
};

#include "map.glsl"

const float KEY_STEPS = 2097151.0; // of a share in a key: 21 bits

// One of five vertices of a part, the centre first.
struct Part {
    uint slot, key; // key 0: an old vertex
    uint parent;
    float own;
    vec2 place; // in the parent, from -1 to 1
    bool even;
};

Part take_part()
{
    uint index = gl_GlobalInvocationID.x / 5u, which = gl_GlobalInvocationID.x % 5u, corner = which - 1u;
    Part part = Part(NONE, 0u, 0u, 1.0, vec2(0.0), false);
    if (index >= quad_count[level])
        return part;
    index += quad_first[level];
    uint pixel = which == 0u ? quads[index].centre : quads[index].corners[corner];
    part.even = is_even(quads[index]);
    part.slot = vertex_slot(pixel, part.even);
    part.parent = quads[index].parent;
    part.own = quads[part.parent].own;
    ivec2 size = unpack_size(quads[index].size), whole = unpack_size(quads[part.parent].size);
    ivec2 first = unpack_pixel(quads[index].origin) - unpack_pixel(quads[part.parent].origin);
    ivec2 at = first + (which == 0u ? size / 2 : size * ivec2(corner & 1u, corner >> 1));
    part.place = 2.0 * vec2(at) / vec2(whole) - 1.0;
    // by its share; of two places in one quad always the same one
    uvec2 row = uvec2(at) / 2u;
    if (is_new(part.slot))
        part.key = 1u + (uint(part.own * KEY_STEPS) << 10 | row.y << 5 | row.x);
    return part;
}
