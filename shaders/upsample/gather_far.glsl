// gather_far.glsl: a sample of far.glsl at one pixel of each block, TOGETHER an invocation: of the far
// lights, or with ALL_LIGHTS of all of them, one by one.
#define TOGETHER 4
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "../hull/hull.glsl"
#include "../hull/control.glsl"
#ifdef ALL_LIGHTS
#include "../common/lights.glsl"
#else
#include "../hull/descent.glsl"
#endif
#include "../common/form_factor.glsl"
#include "../hull/moments.glsl"
#include "far.glsl"
#include "block.glsl"

layout(local_size_x = 16) in; // with TOGETHER 64 samples

layout(set = 0, binding = 4) uniform sampler2D position_image;
layout(set = 0, binding = 5) uniform usampler2D normal_image;
layout(set = 0, binding = 6, std430) writeonly buffer Samples
{
    Sample samples[];
};

// Takes the share far of a light of exitance e into the sample, and into the irradiance at its normal.
void take(inout Sample s, vec3 e, float far, float form_factor, Moments m, Fourth f)
{
    s.c.xyz += e * (far * form_factor);
    TAKE_FAR(s, e, far, m, f)
}

// The share of the light that the sample at x is to take, with its exact form factor and moments.
void take_exactly(inout Sample s, Light l, vec3 e, float far)
{
    vec3 x = s.position.xyz, n = s.normal.xyz;
    far = dot(x - l.a.xyz, l.plane.xyz) < light_closest ? 0.0 : far;
    take(s, e, far, form_factor(l, x, n), light_moments(l, x), far_light(l, x, n).fourth);
}

#ifdef ALL_LIGHTS

shared Light staged[64];

void gather(inout Sample s[TOGETHER], bool surface[TOGETHER], inout uint done)
{
    for (uint first = 0u; first < view.size.z; first += 64u) {
        barrier();
        for (uint i = gl_LocalInvocationIndex; i < 64u && first + i < view.size.z; i += 16u)
            staged[i] = lights[first + i];
        barrier();
        uint count = min(64u, view.size.z - first), i = 0u;
        do {
            Light l = staged[i];
            [[unroll]] for (int k = 0; k < TOGETHER; k++) {
                take_exactly(s[k], l, light_exitance(l), surface[k] ? 1.0 : 0.0);
                done += surface[k] ? 1u : 0u;
            }
        } while (++i < count);
    }
}

#else

void gather(inout Sample s[TOGETHER], bool surface[TOGETHER], inout uint done)
{
    Seeker seekers[TOGETHER];
    [[unroll]] for (int k = 0; k < TOGETHER; k++)
        seekers[k] = Seeker(s[k].position.xyz, s[k].position.w, surface[k] ? 0u : nodes_end);
    uint at = 0u;
    if (nodes_end > 0u)
        do {
            find_lights(at, seekers, mean, done);
            uint i = 0u;
            if (found_far_count > 0u)
                do {
                    Light l = node_light(found_far[i] & FOUND_NODES);
                    [[unroll]] for (int k = 0; k < TOGETHER; k++) {
                        bool own = is_found_for(found_far[i], k);
                        done += own ? 1u : 0u;
                        FarLight f = far_light(l, s[k].position.xyz, s[k].normal.xyz);
                        take(s[k], light_exitance(l), own ? 1.0 : 0.0, f.form_factor, f.moments, f.fourth);
                    }
                } while (++i < found_far_count);
            i = 0u;
            if (found_near_count > 0u)
                do {
                    uint which = found_near[i] & FOUND_NODES;
                    Light l = node_light(which);
                    bool leaf = is_leaf(which);
                    [[unroll]] for (int k = 0; k < TOGETHER; k++) {
                        bool own = is_found_for(found_near[i], k);
                        done += own ? 1u : 0u;
                        vec3 gradient;
                        float far = far_share(l, leaf, s[k].position.xyz, s[k].position.w, mean, gradient);
                        take_exactly(s[k], l, light_exitance(l), own ? far : 0.0);
                    }
                } while (++i < found_near_count);
        } while (at < nodes_end);
}

#endif

void main()
{
    uint first = TOGETHER * gl_GlobalInvocationID.x, done = 0u, length = uint(samples.length());
    Sample s[TOGETHER];
    bool surface[TOGETHER];
    [[unroll]] for (int k = 0; k < TOGETHER; k++) {
        uint index = first + uint(k);
        ivec2 block = ivec2(index % blocks_x, int(index / blocks_x) + band_first(length)), pixel = ivec2(0);
        s[k] = Sample(vec4(0), vec4(0), vec4(0), vec4(0), vec4(0), vec4(0), vec4(0), vec4(0), vec4(0), vec4(0),
                      vec4(0), vec4(0));
        if (index < length && block.y >= 0 && block.y < int(blocks_y))
            pixel = block_pixel(block, position_image, s[k].position);
        surface[k] = s[k].position.w > 0.0;
        uvec2 normals = surface[k] ? texelFetch(normal_image, pixel, 0).xy : uvec2(0u);
        vec3 n = unpack_normal(normals.x), face = unpack_normal(normals.y);
        s[k].normal.xyz = dot(n, face) > 0.97 ? n : face; // as the hull's vertices do
    }
    gather(s, surface, done);
    [[unroll]] for (int k = 0; k < TOGETHER; k++)
        if (first + uint(k) < length) {
            s[k].c.w = spot_of(s[k].red0.xyz + s[k].green0.xyz + s[k].blue0.xyz, sample_axis(s[k]),
                               Fourth(s[k].fourth_a, s[k].fourth_b, s[k].b.w));
            s[k].c.xyz -= sample_irradiance(s[k], s[k].normal.xyz);
            samples[first + uint(k)] = s[k];
        }
    counter_add_group(COUNT_EVALUATIONS, done);
}
