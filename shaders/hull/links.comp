#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// links.comp: which neighbouring pixels lie on one surface, as bits: an invocation walks along some
// rows of a tile, so that it reads few pixels twice. On the way it notes the bounds of each 8 x ROWS
// pixels for choosing near lights.
#include "../common/frame.glsl"
#include "hull.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 1) uniform sampler2D position_image;
layout(set = 0, binding = 2) uniform usampler2D normal_image;
layout(set = 0, binding = 3, std430) writeonly buffer Links
{
    uvec4 links[]; // a row: surface, linked to the right, linked downwards; shading normals differ
};
layout(set = 0, binding = 4, std430) writeonly buffer RowBounds
{
    vec4 row_bounds[]; // 8 x ROWS pixels: least corner, greatest depth; greatest corner
};

const int PARTS = TILE / ROWS; // of a tile

struct Pixel {
    vec4 position;
    vec3 normal;  // of the triangle
    uint shading; // packed shading normal
};

Pixel fetch(ivec2 p)
{
    bool inside = all(lessThan(p, ivec2(view.size.xy)));
    vec4 position = inside ? texelFetch(position_image, p, 0) : vec4(0.0);
    uvec2 normals = inside ? texelFetch(normal_image, p, 0).xy : uvec2(0u);
    return Pixel(position, unpack_normal(normals.y), normals.x);
}

// The same surface: neither pixel lies off the other's plane, and their normals agree.
bool linked(Pixel p, Pixel q)
{
    vec3 d = q.position.xyz - p.position.xyz;
    float nearer = min(p.position.w, q.position.w);
    float off = max(abs(dot(p.normal, d)), abs(dot(q.normal, d)));
    return nearer > 0.0 && off < link_plane * nearer && dot(p.normal, q.normal) > link_cosine;
}

// Do their shading normals differ by more than rounding?
bool differ(Pixel p, Pixel q)
{
    uint a = p.shading, b = q.shading;
    ivec2 x = ivec2(int(a << 16), int(a)) >> 16, y = ivec2(int(b << 16), int(b)) >> 16;
    return any(greaterThan(abs(x - y), ivec2(2)));
}

void main()
{
    uint part = gl_GlobalInvocationID.x, tile = part / uint(PARTS);
    if (tile >= tiles_x * tiles_y)
        return;
    ivec2 p = TILE * ivec2(tile % tiles_x, tile / tiles_x) + ivec2(0, ROWS * int(part % uint(PARTS)));
    uvec4 bits[ROWS];
    Pixel before[ROWS];
    [[unroll]] for (int y = 0; y < ROWS; y++) {
        bits[y] = uvec4(0u);
        before[y] = Pixel(vec4(0.0), vec3(0.0), 0u);
    }
    vec4 low = vec4(3e38, 3e38, 3e38, 0.0);
    vec3 high = vec3(-3e38);
    for (int x = 0; x <= TILE; x++) {
        if (x > 0 && x % 8 == 0) {
            uint at = 2u * (part * uint(TILE / 8) + uint(x / 8 - 1));
            row_bounds[at] = low;
            row_bounds[at + 1u] = vec4(high, 0.0);
            low = vec4(3e38, 3e38, 3e38, 0.0);
            high = vec3(-3e38);
        }
        uint here_bit = x < TILE ? 1u << x : 0u, before_bit = x > 0 ? 1u << (x - 1) : 0u;
        Pixel here = fetch(p + ivec2(x, 0));
        [[unroll]] for (int y = 0; y < ROWS; y++) {
            Pixel below = fetch(p + ivec2(x, y + 1));
            bool right = linked(before[y], here), down = linked(here, below);
            bits[y] |= uvec4(here.position.w > 0.0 ? here_bit : 0u, right ? before_bit : 0u,
                             down ? here_bit : 0u,
                             (right && differ(before[y], here) ? before_bit : 0u)
                                 | (down && differ(here, below) ? here_bit : 0u));
            if (here.position.w > 0.0) {
                low = vec4(min(low.xyz, here.position.xyz), max(low.w, here.position.w));
                high = max(high, here.position.xyz);
            }
            before[y] = here;
            here = below;
        }
    }
    [[unroll]] for (int y = 0; y < ROWS; y++)
        links[part * uint(ROWS) + uint(y)] = bits[y];
}
