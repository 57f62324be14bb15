#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// exact.comp: the light at the pixels of a list, without a hull: every light that is not too far to
// be taken together with others.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "descent.glsl"
#include "../common/form_factor.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 4) uniform sampler2D position_image;
layout(set = 0, binding = 5) uniform usampler2D normal_image;
layout(set = 0, binding = 6, rgba32f) writeonly uniform image2D light_image;
layout(set = 0, binding = 7, std430) readonly buffer Arguments
{
    uint exact_groups[3];
    uint exact_count; // 1 more than there are
};
layout(set = 0, binding = 8, std430) readonly buffer Exact
{
    uint exact_pixels[];
};

void main()
{
    bool inside = gl_GlobalInvocationID.x < exact_count - 1u;
    uint index = inside ? exact_pixels[gl_GlobalInvocationID.x] : 0u, done = 0u;
    ivec2 pixel = ivec2(index % view.size.x, index / view.size.x);
    vec4 place = texelFetch(position_image, pixel, 0);
    vec3 n = unpack_normal(texelFetch(normal_image, pixel, 0).x), irradiance = vec3(0.0);
    Seeker seekers[1] = {Seeker(place.xyz, place.w, 0u)};
    for (uint at = inside ? 0u : nodes_end; at < nodes_end;) {
        find_lights(at, seekers, mean, done);
        done += found_far_count + found_near_count;
        for (uint i = 0u; i < found_far_count + found_near_count; i++) {
            Light l = node_light(found_at(i));
            irradiance += light_exitance(l) * form_factor(l, place.xyz, n);
        }
    }
    if (inside)
        imageStore(light_image, pixel, vec4(irradiance, 1.0));
    counter_add_group(COUNT_EVALUATIONS, done);
}
