#version 450
#extension GL_GOOGLE_include_directive : require
// gather_far.comp: a sample of far.glsl at one pixel of each block.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "../common/form_factor.glsl"
#include "../hull/hull.glsl"
#include "../hull/control.glsl"
#include "../hull/window.glsl"
#include "../hull/moments.glsl"
#include "far.glsl"
#include "block.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 4) uniform sampler2D position_image;
layout(set = 0, binding = 5) uniform usampler2D normal_image;
layout(set = 0, binding = 6, std430) writeonly buffer Samples
{
    Sample samples[];
};

shared Light staged[64];

void main()
{
    uint index = gl_GlobalInvocationID.x, count = view.size.z;
    ivec2 block = ivec2(index % blocks_x, int(index / blocks_x) + band_first(samples.length()));
    bool inside = index < samples.length() && block.y >= 0 && block.y < int(blocks_y);
    Sample s = Sample(vec4(0), vec4(0), vec4(0), vec4(0), vec4(0), vec4(0), vec4(0), vec4(0), vec4(0),
                      vec4(0), vec4(0), vec4(0));
    ivec2 pixel = ivec2(0);
    if (inside)
        pixel = block_pixel(block, position_image, s.position);
    bool surface = s.position.w > 0.0;
    uvec2 normals = surface ? texelFetch(normal_image, pixel, 0).xy : uvec2(0u);
    vec3 n = unpack_normal(normals.x), face = unpack_normal(normals.y), exact = vec3(0.0);
    n = dot(n, face) > 0.97 ? n : face; // as the hull's vertices do
    for (uint first = 0u; first < count; first += 64u) {
        uint mine = first + gl_LocalInvocationIndex;
        if (mine < count)
            staged[gl_LocalInvocationIndex] = lights[mine];
        barrier();
        uint last = surface ? min(64u, count - first) : 0u;
        for (uint i = 0u; i < last; i++) {
            Light l = staged[i];
            vec3 gradient = vec3(0.0);
            float far = 1.0;
            if (tau > 0.0)
                far -= near_weight(l, s.position.xyz, s.position.w, mean, gradient);
            far = dot(s.position.xyz - l.a.xyz, l.plane.xyz) < light_closest ? 0.0 : far;
            vec3 e = far * light_exitance(l);
            exact += e * form_factor(l, s.position.xyz, n);
            Moments m = light_moments(l, s.position.xyz);
            vec3 square = (15.0 / 32.0 * m.squares + 3.0 / 32.0 * m.solid_angle) / PI;
            vec3 product = 15.0 / 32.0 / PI * m.products, b = 0.5 / PI * m.first;
            vec4 m0 = vec4(square, product.x), m1 = vec4(product.yz, b.xy);
            s.red0 += e.r * m0;
            s.green0 += e.g * m0;
            s.blue0 += e.b * m0;
            s.red1 += e.r * m1;
            s.green1 += e.g * m1;
            s.blue1 += e.b * m1;
            Fourth f = light_fourth(l, s.position.xyz);
            float mean_e = (e.r + e.g + e.b) / 3.0;
            s.b += vec4(e * b.z, mean_e * f.c);
            s.fourth_a += mean_e * f.a;
            s.fourth_b += mean_e * f.b;
        }
        barrier();
    }
    s.c.xyz = exact - sample_irradiance(s, n);
    s.normal.xyz = n;
    if (inside)
        samples[index] = s;
    counter_add_group(COUNT_EVALUATIONS, surface ? count : 0u);
}
