// split.glsl: which quads of a level are to be split: those whose corners do not predict their centre.
// The error is that of four corners; with the centre a leaf keeps about a quarter of it. It is
// also a quad's rank, should there be no room for the parts of all (part.comp). Along a wall seen
// edge-on a quad of 4 pixels may be as long as a room, and all its light lie between its corners: what
// errs much and is too small for parts is lit exactly.
#include "../common/frame.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "vertex_kind.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 2, std430) readonly buffer Links
{
    uvec4 links[];
};
layout(set = 0, binding = 3, std430) readonly buffer Masks
{
    uint masks[];
};
layout(set = 0, binding = 4, std430) readonly buffer Map
{
    uint map[];
};
layout(set = 0, binding = 5, std430) readonly buffer EvenMap
{
    uint even_map[];
};
layout(set = 0, binding = 6, std430) buffer Quads
{
    Quad quads[];
};
layout(set = 0, binding = 7, std430) readonly buffer Vertices
{
    Vertex vertices[];
};
layout(set = 0, binding = 8) uniform sampler2D position_image;
layout(set = 0, binding = 9) uniform usampler2D normal_image;

#define MEMBER_READ_ONLY
#include "member.glsl"

const float STEEP = 1.0; // see change_across
const float COARSE = 8.0; // error, of that which splits, from where on quads too small for parts are lit exactly

// By the four corners; and by the two that two triangles have in common, see emit.comp.
vec2 split_errors(Quad q)
{
    ivec2 pixel = unpack_pixel(q.centre);
    vec3 x = texelFetch(position_image, pixel, 0).xyz;
    vec3 n = vertex_normal(texelFetch(normal_image, pixel, 0).xy);
    Vertex middle = vertex_zero(), diagonal = vertex_zero();
    for (int i = 0; i < 4; i++) {
        Vertex corner = vertices[vertex_slot(q.corners[i], is_even(q))];
        vertex_add(middle, 0.25, corner);
        vertex_add(diagonal, i == 0 || i == 3 ? 0.5 : 0.0, corner);
    }
    vec3 light = vertex_irradiance(vertices[vertex_slot(q.centre, is_even(q))], x, n);
    return inversesqrt(3.0) * vec2(distance(light, vertex_irradiance(middle, x, n)),
                                   distance(light, vertex_irradiance(diagonal, x, n)));
}

// How much the light changes, by the gradient at the centre, from one end to the other of the row of
// the component that the centre is in; down: of its column.
float change_across(Quad q, bool down)
{
    ivec2 tile = tile_origin(q.component), centre = unpack_pixel(q.centre) - tile;
    int first = TILE, last = 0;
    if (down) {
        for (int y = 0; y < TILE; y++)
            if (bit(masks[q.component * uint(TILE) + uint(y)], centre.x)) {
                first = min(first, y);
                last = y;
            }
    } else {
        uint row = masks[q.component * uint(TILE) + uint(centre.y)];
        first = findLSB(row);
        last = findMSB(row);
    }
    ivec2 a = tile + (down ? ivec2(centre.x, first) : ivec2(first, centre.y));
    ivec2 b = tile + (down ? ivec2(centre.x, last) : ivec2(last, centre.y));
    vec3 d = texelFetch(position_image, b, 0).xyz - texelFetch(position_image, a, 0).xyz;
    Vertex v = vertices[vertex_slot(q.centre, is_even(q))];
    vec3 change = vec3(dot(v.gradient0.xyz, d), dot(v.gradient1.xyz, d), dot(v.gradient2.xyz, d));
    return length(change) * inversesqrt(3.0);
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= quad_count[level])
        return;
    index += quad_first[level];
    Quad q = quads[index];
    if (q.component == NONE)
        return;
    ivec2 size = unpack_size(q.size), p = unpack_pixel(q.origin) - tile_origin(q.component);
    ivec2 first = first_part(size);
    vec2 errors = split_errors(q);
    float error = errors.x, most = split * mean;
    // with one vertex across nothing is known of the other places there but the gradient
    if (level == 0u && size.x <= ONE_VERTEX && size.x > STEP)
        error = max(error, STEEP * change_across(q, false));
    if (level == 0u && size.y <= ONE_VERTEX && size.y > STEP)
        error = max(error, STEEP * change_across(q, true));
    quads[index].own = clamp(0.5 * error / max(most, 1e-30) - 0.5, 0.0, 1.0);
    uint children = 0u, rank = 0u;
    bool parts = level + 1u < LEVELS && size != first; // else too small for them
    if (parts && error > most) {
        for (int i = 0; i < 4; i++) {
            ivec2 part = ivec2(i & 1, i >> 1), extent = part_size(size, part);
            if (all(greaterThan(extent, ivec2(0)))
                && has_members(q.component, p + part * first, extent))
                children |= 1u << i;
        }
        // at most a centre and four corners each; four parts share some, and with their quad
        uint count = uint(bitCount(children));
        rank = uint(min(2.0 * log2(error / most), float(RANKS - 1u)));
        atomicAdd(wanted_quads[rank], count);
        atomicAdd(wanted_vertices[rank], count == 4u ? 9u : 5u * count);
    }
    quads[index].size = pack_pixel(size) | (q.size & EVEN_BIT) | (max(error, errors.y) < FLAT * most ? FLAT_BIT : 0u) | rank << 8
        | children << 24 | (!parts && error > COARSE * most ? EXACT_BIT : 0u);
}
