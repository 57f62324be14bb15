#version 450
#extension GL_GOOGLE_include_directive : require
// exact.comp: every light at the pixels of a list, 256 of them a work group; there may be more groups than
// that needs.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#include "../common/frame.glsl"
#include "../common/counters.glsl"

layout(set = 0, binding = 3) uniform sampler2D position_image;
layout(set = 0, binding = 4) uniform usampler2D normal_image;
layout(set = 0, binding = 5, rgba32f) writeonly uniform image2D light_image;
layout(set = 0, binding = 6, std430) readonly buffer Arguments
{
    uint exact_groups[3];
    uint exact_count; // 1 more than there are
};
layout(set = 0, binding = 7, std430) readonly buffer Exact
{
    uint exact_pixels[];
};

// The pixel of a place in the work group's tile of 16 x 16; false past the end of the list.
bool find_pixel(uvec2 place, out ivec2 pixel)
{
    uvec2 inside = place - 16u * gl_WorkGroupID.xy;
    uint index = 256u * gl_WorkGroupID.x + 16u * inside.y + inside.x;
    bool there = index < exact_count - 1u;
    uint at = there ? exact_pixels[index] : 0u;
    pixel = ivec2(at % view.size.x, at / view.size.x);
    return there;
}

bool read_place(uvec2 place, out vec3 x, out vec3 n)
{
    ivec2 pixel;
    bool there = find_pixel(place, pixel);
    x = texelFetch(position_image, pixel, 0).xyz;
    n = unpack_normal(texelFetch(normal_image, pixel, 0).x);
    return there;
}

void write_place(uvec2 place, bool surface, vec3 irradiance)
{
    ivec2 pixel;
    if (find_pixel(place, pixel))
        imageStore(light_image, pixel, vec4(irradiance, 1.0));
}

#include "../exact/four.glsl"
