// additional.glsl: additional samples (3.1.4): three pixels of each final fragment above level 2:
// top left, top centre, left centre.
#ifndef ADDITIONAL_GLSL
#define ADDITIONAL_GLSL

#include "fragments.glsl"
#include "visibility.glsl"
#include "lobe.glsl"

layout(local_size_x = 48) in; // 16 fragments

void main()
{
    uint entry, which = gl_LocalInvocationIndex / 3u, place = gl_LocalInvocationIndex % 3u;
    bool taken = take_fragment(0u, which, entry);
    uint l = taken ? entry >> 28 & 7u : 1u, h = 1u << (l - 1u), rays = 0u, light = first_light;
    uvec2 pixel = (unpack_fragment(entry) << l) + h * uvec2(place == 1u, place == 2u);
    Surface s = surface_at(ivec2(pixel));
    uint index = fragment_index(0u, pixel);
    vec3 light_sum = taken && first_light > 0u ? illumination[index].rgb : vec3(0.0);
    for (; taken && light < last_light; light++) {
        float form = s.there ? form_before_test(light, s) : 0.0;
        vec2 seen = vec2(0.0);
        uint sets = form > 0.0 ? 1u : 0u;
        for (uint set = 0u; set < sets; set++) {
            uint bits = see_set(light, s, set, seen, rays);
            bool more = in_part(bits) || (bits != 0u && worth_of(light, form) > BRIGHT);
            if (set == 0u && more && points != POINTS_SAME)
                sets = 4u;
        }
        form = form_after_test(light, s, form, seen.x, seen.y);
        if (seen.x > 0.0)
            light_sum += areas[light].exitance.rgb * (form * seen.x / seen.y);
    }
    trace_gave_up = trace_gave_up || (taken && light < last_light);
    if (taken)
        illumination[index] = vec4(light_sum, SAMPLE);
    uint counted = taken && first_light == 0u ? 1u : 0u;
    counter_add_group(COUNT_SAMPLES, counted);
    counter_add_group(COUNT_FRAGMENTS, counted);
    counter_add_group(COUNT_EVALUATIONS, counted * light_count);
    count_rays(rays);
}

#endif
