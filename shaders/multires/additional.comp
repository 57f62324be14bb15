#version 450
#extension GL_GOOGLE_include_directive : require
// additional.comp: additional samples (3.1.4): three pixels of each final fragment above level 2:
// top left, top centre, left centre.
#define PLACES 3u
#include "fragments.glsl"
#include "visibility.glsl"

layout(local_size_x = 48) in;

void main()
{
    uint entry;
    if (!take_fragment(0u, entry))
        return;
    uint l = entry >> 28 & 7u, place = gl_LocalInvocationIndex % PLACES;
    uint h = 1u << (l - 1u);
    uvec2 pixel = (unpack_fragment(entry) << l) + h * uvec2(place == 1u, place == 2u);
    Surface s = surface_at(ivec2(pixel));
    vec3 light_sum = vec3(0.0);
    bool one = gl_LocalInvocationIndex < PLACES;
    uint rays = 0u;
    uint light = 0u;
    for (; light < light_count; light++) {
        Surface t = s;
        vec2 seen = vec2(0.0);
        for (uint set = 0u; set < (points == POINTS_SAME ? 1u : 4u); set++) {
            see_light(light, t, set, rays);
            if (one)
                seen += sum_place(place);
            if (set == 0u) // the other points where some of these are seen, but not all
                t.there = place_bits[place] != 0u && place_bits[place] != 0xffffu;
            barrier();
        }
        if (seen.x > 0.0)
            light_sum += areas[light].exitance.rgb * (area_form_factor(light, s) * seen.x / seen.y);
    }
    trace_gave_up = trace_gave_up || light < light_count;
    if (one)
        illumination[fragment_index(0u, pixel)] = vec4(light_sum, SAMPLE);
    if (gl_LocalInvocationIndex == 0u) {
        counter_add(COUNT_SAMPLES, 3u);
        counter_add(COUNT_EVALUATIONS, 3u * light_count);
    }
    count_rays(rays);
}
