#version 450
#extension GL_GOOGLE_include_directive : require
// trace.comp: the fragments of one level, 64 rays from each to every light (Nichols, Penmatsa and
// Wyman 2010).
#include "../multires/fragments.glsl"
#include "../shadows/full.glsl"
#include "bits.glsl"

layout(local_size_x = 64) in;

// Four pixels of different surfaces: fragments each, not to be compared.
void split(uvec2 at)
{
    if (gl_LocalInvocationIndex < 4u) {
        uvec2 child = at * 2u + uvec2(gl_LocalInvocationIndex & 1u, gl_LocalInvocationIndex >> 1);
        if (surface_at(ivec2(child)).there)
            push_fragment(0u, pack_fragment(child, 0u));
    }
}

void main()
{
    uint entry;
    if (!take_fragment(level, entry))
        return;
    uvec2 at = unpack_fragment(entry);
    if ((entry & FORCED) != 0u) {
        split(at);
        return;
    }
    uint index = fragment_index(level, at), kept = index * (light_count + 1u);
    Surface s = surface_at(fragment_pixel(level, at));
    vec3 sum = vec3(0.0);
    uint rays = 0u;
    uint light = 0u;
    for (; light < light_count; light++) {
        sum += full_light(light, s, rays);
        if (gl_LocalInvocationIndex == 0u)
            visible[kept + 1u + light] = uvec2(full_bits[0], full_bits[1]);
        barrier();
    }
    trace_gave_up = trace_gave_up || light < light_count;
    if (gl_LocalInvocationIndex == 0u) {
        illumination[index] = vec4(sum, level == 0u ? FINAL : NOTHING);
        visible[kept] = uvec2(1u, 0u);
        counter_add(COUNT_SAMPLES, 1u);
        counter_add(COUNT_EVALUATIONS, light_count);
        if (level == 0u)
            counter_add(COUNT_FRAGMENTS, 1u);
    }
    count_rays(rays);
}
