#version 450
#extension GL_GOOGLE_include_directive : require
// trace.comp: the fragments of one level, 64 rays from each to every light (Nichols, Penmatsa and
// Wyman 2010).
#include "../multires/fragments.glsl"
#include "bits.glsl"

layout(local_size_x = 64) in;

shared uint bits[2];
shared float seen_weights[64], weights[64];

// Four pixels of different surfaces: fragments each, not to be compared.
void split(uvec2 at)
{
    if (gl_LocalInvocationIndex < 4u) {
        uvec2 child = at * 2u + uvec2(gl_LocalInvocationIndex & 1u, gl_LocalInvocationIndex >> 1);
        if (surface_at(ivec2(child)).there)
            push_fragment(0u, pack_fragment(child, 0u));
    }
}

vec3 light_fragment(uint light, Surface s, uint kept, inout uint rays)
{
    uint mine = gl_LocalInvocationIndex;
    if (mine < 2u)
        bits[mine] = 0u;
    float form = area_form_factor(light, s);
    float weight = form > 0.0 ? area_weight(light, mine, s) : 0.0;
    bool sees = false;
    if (weight > 0.0) {
        sees = area_sees(light, mine, s);
        rays++;
    }
    seen_weights[mine] = sees ? weight : 0.0;
    weights[mine] = weight;
    barrier();
    if (sees)
        atomicOr(bits[mine >> 5], 1u << (mine & 31u));
    barrier();
    float seen = 0.0, all = 0.0;
    for (uint i = 0u; mine == 0u && i < 64u; i++) {
        seen += seen_weights[i];
        all += weights[i];
    }
    if (mine == 0u)
        visible[kept + 1u + light] = uvec2(bits[0], bits[1]);
    barrier();
    return seen > 0.0 ? areas[light].exitance.rgb * (form * seen / all) : vec3(0.0);
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
    for (uint light = 0u; light < light_count; light++)
        sum += light_fragment(light, s, kept, rays);
    if (gl_LocalInvocationIndex == 0u) {
        illumination[index] = vec4(sum, level == 0u ? FINAL : NOTHING);
        visible[kept] = uvec2(1u, 0u);
        counter_add(COUNT_SAMPLES, 1u);
        counter_add(COUNT_EVALUATIONS, light_count);
        if (level == 0u)
            counter_add(COUNT_FRAGMENTS, 1u);
    }
    counter_add_group(COUNT_RAYS, rays);
}
