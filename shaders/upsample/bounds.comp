#version 450
#extension GL_GOOGLE_include_directive : require
// bounds.comp: bounds of each 8 x ROWS pixels, as hull/links.comp notes them on its way.
#include "../common/frame.glsl"
#include "../hull/hull.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 1) uniform sampler2D position_image;
layout(set = 0, binding = 2, std430) writeonly buffer RowBounds
{
    vec4 row_bounds[];
};

void main()
{
    uint index = gl_GlobalInvocationID.x, row = index / uint(TILE / 8), part = index % uint(TILE / 8);
    uint tile = row / uint(TILE / ROWS);
    if (tile >= tiles_x * tiles_y)
        return;
    ivec2 first = TILE * ivec2(tile % tiles_x, tile / tiles_x) + ivec2(8u * part, uint(ROWS) * (row % uint(TILE / ROWS)));
    vec4 low = vec4(3e38, 3e38, 3e38, 0.0);
    vec3 high = vec3(-3e38);
    for (int i = 0; i < 8 * ROWS; i++) {
        ivec2 p = first + ivec2(i % 8, i / 8);
        bool inside = all(lessThan(p, ivec2(view.size.xy)));
        vec4 here = inside ? texelFetch(position_image, p, 0) : vec4(0.0);
        if (here.w > 0.0) {
            low = vec4(min(low.xyz, here.xyz), max(low.w, here.w));
            high = max(high, here.xyz);
        }
    }
    row_bounds[2u * index] = low;
    row_bounds[2u * index + 1u] = vec4(high, 0.0);
}
