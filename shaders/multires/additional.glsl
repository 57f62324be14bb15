// additional.glsl: additional samples (3.1.4): three pixels of each final fragment above level 2:
// top left, top centre, left centre.
#ifndef ADDITIONAL_GLSL
#define ADDITIONAL_GLSL

#include "fragments.glsl"
#include "visibility.glsl"
#include "lobe.glsl"
#include "queue.glsl"

layout(local_size_x = 64) in; // 16 fragments; the fourth of four has nothing to do

// By 16 points, and by all where some of them are visible and the light is bright or others are not.
vec3 look_at_light(uint light, Surface s, inout uint rays)
{
    float form = s.there ? form_before_test(light, s) : 0.0;
    uvec2 left = form > 0.0 ? squares_of(0u) : uvec2(0u), board = uvec2(0u);
    vec2 weights = vec2(0.0);
    for (uint turn = 0u; turn < 2u; turn++) {
        if (turn > 0u) {
            uint count = count_squares(board);
            bool more = count > 0u && (count < AREA_FEW || worth_of(light, form) > BRIGHT);
            left = more && points != POINTS_SAME ? ~left : uvec2(0u);
        }
        float weight;
        uvec2 faced = facing(light, s, left, weight);
        weights.y += weight;
        rays += count_squares(faced);
        queue_ask(s, faced);
        queue_trace(light);
        board |= queue_answer(gl_LocalInvocationIndex);
        barrier();
    }
    facing(light, s, board, weights.x);
    form = form_after_test(light, s, form, weights.x, weights.y);
    return weights.x > 0.0 ? areas[light].exitance.rgb * (form * weights.x / weights.y) : vec3(0.0);
}

void main()
{
    uint entry, which = gl_LocalInvocationIndex / 4u, place = gl_LocalInvocationIndex & 3u;
    bool taken = take_fragment(0u, which, entry) && place < 3u;
    uint l = taken ? entry >> 28 & 7u : 1u, h = 1u << (l - 1u), rays = 0u, light = first_light;
    uvec2 pixel = (unpack_fragment(entry) << l) + h * uvec2(place == 1u, place == 2u);
    Surface s = surface_at(ivec2(pixel));
    s.there = s.there && taken;
    uint index = fragment_index(0u, pixel);
    vec3 light_sum = taken && first_light > 0u ? illumination[index].rgb : vec3(0.0);
    for (; light < last_light; light++)
        light_sum += look_at_light(light, s, rays);
    trace_gave_up = trace_gave_up || light < last_light;
    if (taken)
        illumination[index] = vec4(light_sum, SAMPLE);
    uint counted = taken && first_light == 0u ? 1u : 0u;
    counter_add_group(COUNT_SAMPLES, counted);
    counter_add_group(COUNT_FRAGMENTS, counted);
    counter_add_group(COUNT_EVALUATIONS, counted * light_count);
    count_rays(rays);
}

#endif
