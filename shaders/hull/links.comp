#version 450
#extension GL_GOOGLE_include_directive : require
// links.comp: which neighbouring pixels lie on one surface, as bits: an invocation walks along one
// row of a tile. On the way it notes the bounds of each 8 pixels for choosing near lights.
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
    vec4 row_bounds[]; // 8 pixels: least corner, greatest depth; greatest corner
};

void fetch(ivec2 p, out vec4 position, out vec3 normal, out uint shading)
{
    bool inside = all(lessThan(p, ivec2(view.size.xy)));
    position = inside ? texelFetch(position_image, p, 0) : vec4(0.0);
    uvec2 normals = inside ? texelFetch(normal_image, p, 0).xy : uvec2(0u);
    shading = normals.x;
    normal = unpack_normal(normals.y);
}

// The same surface: neither pixel lies off the other's plane, and their normals agree.
bool linked(vec4 p, vec3 n, vec4 q, vec3 m)
{
    vec3 d = q.xyz - p.xyz;
    float nearer = min(p.w, q.w);
    float off = max(abs(dot(n, d)), abs(dot(m, d)));
    return nearer > 0.0 && off < link_plane * nearer && dot(n, m) > link_cosine;
}

// Do two packed normals differ by more than rounding?
bool differ(uint a, uint b)
{
    ivec2 x = ivec2(int(a << 16), int(a)) >> 16, y = ivec2(int(b << 16), int(b)) >> 16;
    return any(greaterThan(abs(x - y), ivec2(2)));
}

void main()
{
    uint row = gl_GlobalInvocationID.x, tile = row / uint(TILE);
    if (tile >= tiles_x * tiles_y)
        return;
    ivec2 p = TILE * ivec2(tile % tiles_x, tile / tiles_x) + ivec2(0, row % uint(TILE));
    uint surface = 0u, right = 0u, down = 0u, uneven = 0u, before_shading = 0u;
    vec4 low = vec4(3e38, 3e38, 3e38, 0.0);
    vec3 high = vec3(-3e38);
    vec4 before = vec4(0.0);
    vec3 before_normal = vec3(0.0);
    for (int x = 0; x <= TILE; x++) {
        vec4 here, below;
        vec3 normal, below_normal;
        uint shading, below_shading;
        fetch(p + ivec2(x, 0), here, normal, shading);
        fetch(p + ivec2(x, 1), below, below_normal, below_shading);
        if (x > 0 && linked(before, before_normal, here, normal)) {
            right |= 1u << (x - 1);
            uneven |= differ(before_shading, shading) ? 1u << (x - 1) : 0u;
        }
        if (x > 0 && x % 8 == 0) {
            uint at = 2u * (row * uint(TILE / 8) + uint(x / 8 - 1));
            row_bounds[at] = low;
            row_bounds[at + 1u] = vec4(high, 0.0);
            low = vec4(3e38, 3e38, 3e38, 0.0);
            high = vec3(-3e38);
        }
        if (here.w > 0.0 && x < TILE) {
            surface |= 1u << x;
            bool on = linked(here, normal, below, below_normal);
            down |= on ? 1u << x : 0u;
            uneven |= on && differ(shading, below_shading) ? 1u << x : 0u;
            low = vec4(min(low.xyz, here.xyz), max(low.w, here.w));
            high = max(high, here.xyz);
        }
        before = here;
        before_normal = normal;
        before_shading = shading;
    }
    links[row] = uvec4(surface, right, down, uneven);
}
