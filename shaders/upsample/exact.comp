#version 450
#extension GL_GOOGLE_include_directive : require
// exact.comp: every light at the pixels of a list.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "../common/form_factor.glsl"

layout(local_size_x = 64) in;

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

shared Light staged[64];

void main()
{
    uint count = view.size.z;
    bool inside = gl_GlobalInvocationID.x < exact_count - 1u;
    uint index = inside ? exact_pixels[gl_GlobalInvocationID.x] : 0u;
    ivec2 pixel = ivec2(index % view.size.x, index / view.size.x);
    vec3 x = texelFetch(position_image, pixel, 0).xyz;
    vec3 n = unpack_normal(texelFetch(normal_image, pixel, 0).x);
    vec3 irradiance = vec3(0.0);
    for (uint first = 0u; first < count; first += 64u) {
        uint mine = first + gl_LocalInvocationIndex;
        if (mine < count)
            staged[gl_LocalInvocationIndex] = lights[mine];
        barrier();
        uint last = min(64u, count - first);
        for (uint i = 0u; i < last; i++)
            irradiance += light_exitance(staged[i]) * form_factor(staged[i], x, n);
        barrier();
    }
    if (inside)
        imageStore(light_image, pixel, vec4(irradiance, 1.0));
    counter_add_group(COUNT_EVALUATIONS, inside ? count : 0u);
}
