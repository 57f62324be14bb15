#version 450
#extension GL_GOOGLE_include_directive : require
// trace.comp: the fragments of one level, 64 rays from each to every light (Nichols, Penmatsa and
// Wyman 2010). One fragment an invocation: neighbours follow much the same way through the tree. A
// dispatch does some of the lights.
#include "../multires/fragments.glsl"
#include "bits.glsl"

layout(local_size_x = 64) in;

// Four pixels of different surfaces: fragments each, not to be compared.
void split(uvec2 at)
{
    uint pixels[4], count = 0u;
    for (uint i = 0u; i < 4u; i++) {
        uvec2 child = at * 2u + sub_at(i);
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
        sum += area_irradiance(light, 0u, AREA_POINTS, s, bits, rays);
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
