#version 450
#extension GL_GOOGLE_include_directive : require
// trace.comp: the fragments of one level, 64 rays from each to every light (Nichols, Penmatsa and
// Wyman 2010). One fragment an invocation: neighbours follow much the same way through the tree. A
// dispatch does some of the lights.
#include "../multires/fragments.glsl"
#include "bits.glsl"

layout(local_size_x = 64) in;

// Irradiance from one light by all 64 rays; bits: of the points that are visible.
vec3 light_fragment(uint light, Surface s, out uvec2 bits, inout uint rays)
{
    float form = s.there ? area_form_factor(light, s) : 0.0, seen = 0.0, all = 0.0;
    uint i = 0u, last = trace_any(form > 0.0) ? AREA_POINTS : 0u;
    bits = uvec2(0u);
    for (; i < last; i++) {
        float weight = form > 0.0 ? area_weight(light, i, s) : 0.0;
        all += weight;
        rays += weight > 0.0 ? 1u : 0u;
        if (area_sees(light, i, s, weight > 0.0)) {
            seen += weight;
            bits |= uvec2(i < 32u ? 1u << i : 0u, i < 32u ? 0u : 1u << (i - 32u));
        }
    }
    trace_gave_up = trace_gave_up || i < last;
    return seen > 0.0 ? areas[light].exitance.rgb * (form * seen / all) : vec3(0.0);
}

// Four pixels of different surfaces: fragments each, not to be compared.
void split(uvec2 at)
{
    uint pixels[4], count = 0u;
    for (uint i = 0u; i < 4u; i++) {
        uvec2 child = at * 2u + uvec2(i & 1u, i >> 1);
        if (surface_at(ivec2(child)).there)
            pixels[count++] = pack_fragment(child, 0u);
    }
    if (count > 0u)
        push_fragments(0u, count, pixels);
}

void main()
{
    uint entry, rays = 0u, light = first_light;
    bool listed = take_fragment(level, gl_LocalInvocationIndex, entry);
    bool forced = listed && (entry & FORCED) != 0u, taken = listed && !forced;
    uvec2 at = unpack_fragment(entry);
    if (forced && first_light == 0u)
        split(at);
    uint index = fragment_index(level, at), kept = index * (light_count + 1u);
    Surface s = surface_at(fragment_pixel(level, at));
    s.there = s.there && taken;
    vec3 sum = taken && first_light > 0u ? illumination[index].rgb : vec3(0.0);
    for (; light < last_light; light++) {
        uvec2 bits;
        sum += light_fragment(light, s, bits, rays);
        if (taken)
            visible[kept + 1u + light] = bits;
    }
    trace_gave_up = trace_gave_up || light < last_light;
    if (taken) {
        illumination[index] = vec4(sum, level == 0u ? FINAL : NOTHING);
        visible[kept] = uvec2(1u, 0u);
    }
    uint counted = taken && first_light == 0u ? 1u : 0u;
    counter_add_group(COUNT_SAMPLES, counted);
    counter_add_group(COUNT_EVALUATIONS, counted * light_count);
    counter_add_group(COUNT_FRAGMENTS, level == 0u ? counted : 0u);
    count_rays(rays);
}
