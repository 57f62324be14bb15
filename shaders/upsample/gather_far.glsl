// gather_far.glsl: a sample of far.glsl at one pixel of each block: of the far lights, or with
// ALL_LIGHTS of all of them, one by one.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "../hull/hull.glsl"
#include "../hull/control.glsl"
#ifndef ALL_LIGHTS
#include "../hull/descent.glsl"
#endif
#include "../common/form_factor.glsl"
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

#ifdef ALL_LIGHTS
shared Light staged[64];
#endif

void main()
{
    uint index = gl_GlobalInvocationID.x, done = 0u;
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
#ifdef ALL_LIGHTS
    for (uint first = 0u; first < view.size.z; first += 64u) {
        uint mine = first + gl_LocalInvocationIndex;
        barrier();
        if (mine < view.size.z)
            staged[gl_LocalInvocationIndex] = lights[mine];
        barrier();
        uint count = surface ? min(64u, view.size.z - first) : 0u;
#else
    Seeker seekers[1] = {Seeker(s.position.xyz, s.position.w, 0u)};
    for (uint at = surface ? 0u : nodes_end; at < nodes_end;) {
        find_lights(at, seekers, mean, done);
        uint count = found_far_count + found_near_count;
#endif
        done += count;
        for (uint i = 0u; i < count; i++) {
#ifdef ALL_LIGHTS
            Light l = staged[i];
            float far = 1.0;
#else
            Light l = node_light(found_at(i));
            vec3 gradient;
            float far = 1.0 - near_weight(l, s.position.xyz, s.position.w, mean, gradient);
            far = is_leaf(found_at(i)) ? far : 1.0; // what stands for many is far
#endif
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
            Fourth f = far_light(l, s.position.xyz, n).fourth;
            float mean_e = (e.r + e.g + e.b) / 3.0;
            s.b += vec4(e * b.z, mean_e * f.c);
            s.fourth_a += mean_e * f.a;
            s.fourth_b += mean_e * f.b;
        }
    }
    s.c.xyz = exact - sample_irradiance(s, n);
    s.normal.xyz = n;
    if (inside)
        samples[index] = s;
    counter_add_group(COUNT_EVALUATIONS, done);
}
