#version 450
#extension GL_GOOGLE_include_directive : require
// trace.comp: the fragments of one level, 64 rays from each to every light (Nichols, Penmatsa and
// Wyman 2010).
#include "../multires/fragments.glsl"
#include "bits.glsl"

layout(local_size_x = 64) in;

shared uint fragment_bits[2]; // of the points that are visible
shared float fragment_seen[64], fragment_all[64], fragment_form[8];

// By all 64 rays, one each for the invocations of the work group. In uniform control flow;
// irradiance in the first invocation, 0 in the others.
vec3 light_fragment(uint light, Surface s, inout uint rays)
{
    uint mine = gl_LocalInvocationIndex;
    uvec4 range = areas[light].range;
    if (mine < 2u)
        fragment_bits[mine] = 0u;
    if (mine < range.y) // 6 triangles at most
        fragment_form[mine] = s.there ? form_factor(lights[range.x + mine], s.position, s.normal) : 0.0;
    barrier();
    float form = 0.0, seen = 0.0, all = 0.0;
    for (uint i = 0u; i < range.y; i++)
        form += fragment_form[i];
    float weight = form > 0.0 ? area_weight(light, mine, s) : 0.0;
    bool sees = false;
    if (weight > 0.0) {
        rays++;
        sees = area_sees(light, mine, s);
    }
    fragment_seen[mine] = sees ? weight : 0.0;
    fragment_all[mine] = weight;
    if (sees)
        atomicOr(fragment_bits[mine >> 5], 1u << (mine & 31u));
    barrier();
    for (uint i = 0u; mine == 0u && i < 64u; i++) {
        seen += fragment_seen[i];
        all += fragment_all[i];
    }
    barrier();
    return seen > 0.0 ? areas[light].exitance.rgb * (form * seen / all) : vec3(0.0);
}

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
    if (!take_fragment(level, 0u, entry))
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
        sum += light_fragment(light, s, rays);
        if (gl_LocalInvocationIndex == 0u)
            visible[kept + 1u + light] = uvec2(fragment_bits[0], fragment_bits[1]);
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
