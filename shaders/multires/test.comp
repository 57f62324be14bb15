#version 450
#extension GL_GOOGLE_include_directive : require
// test.comp: sub-fragment visibility tests (3.1.2) and gradient-aware refinement (3.1.3) of the
// fragments of one level. Four sub-fragments, 16 rays each to the same points of a light: where
// their bits differ the fragment is split. Two sub-fragments that follow each other around the
// fragment and whose numbers of visible points differ by more than `steep` are both split once
// more. Where nothing is visible from any of the four, nothing differs, and the fragment is dark.
// What was seen is kept as irradiance: of the sub-fragments of a final fragment, and of pixels.
//
// Joined: the four look at 16 other points each, and share what they see of the 64. That is how
// `points` has it of final fragments in half shadow, which are traced once more, and of the four
// pixels of level 1, unless they are of several surfaces or the shadow is steep: then each pixel in
// half shadow looks at the other 48 points too.
#define PLACES 4u
#include "fragments.glsl"
#include "visibility.glsl"
#include "compare.glsl"

layout(local_size_x = 64) in;

shared vec3 sub_light[4];
shared uint sub_there[4];

// Irradiance in the first four invocations, one for each sub-fragment.
vec3 light_sub(bool joined, bool one_surface, Surface s, inout Found found, inout uint rays)
{
    uint sub = gl_LocalInvocationIndex % PLACES, light = 0u;
    bool one = gl_LocalInvocationIndex < PLACES;
    vec3 sum = vec3(0.0);
    for (; light < light_count; light++) {
        Surface t = s;
        vec2 own = vec2(0.0), together = vec2(0.0);
        bool alone = false;
        for (uint k = 0u; k == 0u || (alone && k < 4u); k++) {
            see_light(light, t, joined ? sub + k & 3u : k, rays);
            if (one)
                own += sum_place(sub);
            if (k == 0u) {
                bool is_steep = compare(joined, found);
                alone = points == POINTS_BOTH && level == 1u && (!one_surface || is_steep);
                if (one && joined && !alone)
                    together = sum_places();
                // the other points where some of these are seen, but not all
                t.there = place_bits[sub] != 0u && place_bits[sub] != 0xffffu;
            }
            barrier();
        }
        vec2 seen = joined && !alone ? together : own;
        if (seen.x > 0.0)
            sum += areas[light].exitance.rgb * (area_form_factor(light, s) * seen.x / seen.y);
    }
    trace_gave_up = trace_gave_up || light < light_count;
    return sum;
}

void keep_pixels(uvec2 at, bool split)
{
    uint kept = 0u;
    for (uint i = 0u; i < 4u; i++) {
        if (sub_there[i] == 0u)
            continue;
        uint index = fragment_index(0u, at * 2u + sub_at(i));
        illumination[index] = vec4(sub_light[i], split ? FINAL : PART);
        kept++;
    }
    counter_add(split ? COUNT_FRAGMENTS : COUNT_FRAGMENTS + 1u, split ? kept : 1u);
}

void split_fragment(uvec2 at, uint twice)
{
    for (uint i = 0u; i < 4u; i++) {
        uvec2 sub = at * 2u + sub_at(i);
        if ((twice >> i & 1u) == 0u)
            push_fragment(level - 1u, pack_fragment(sub, 0u));
        else if (level == 2u)
            push_fragment(1u, pack_fragment(sub, FORCED));
        else
            for (uint k = 0u; k < 4u; k++)
                push_fragment(level - 2u, pack_fragment(sub * 2u + sub_at(k), 0u));
    }
}

void keep_fragment(uvec2 at, uint entry)
{
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < 4u; i++) {
        sum += sub_light[i];
        illumination[fragment_index(level - 1u, at * 2u + sub_at(i))] = vec4(sub_light[i], PART);
    }
    illumination[fragment_index(level, at)] = vec4(0.25 * sum, FINAL);
    if (level > 2u)
        push_fragment(0u, entry | level << 28);
    counter_add(COUNT_FRAGMENTS + level, 1u);
}

void main()
{
    uint entry;
    if (!take_fragment(level, entry))
        return;
    uvec2 at = unpack_fragment(entry);
    uint sub = gl_LocalInvocationIndex % PLACES;
    Surface s = surface_at(fragment_pixel(level - 1u, at * 2u + sub_at(sub)));
    bool one_surface = pyramid[pyramid_index(level, at)] <= 1.0;
    bool joined = (points == POINTS_APART && one_surface) || (points == POINTS_BOTH && level == 1u);
    Found found = Found(0u, 0u, false), again = found;
    uint rays = 0u;
    vec3 light_sum = vec3(0.0);
    bool split = false, half_shadow = true;
    for (uint round = 0u; round < 2u && half_shadow; round++) {
        light_sum = light_sub(joined, one_surface, s, again, rays);
        if (round == 0u) {
            found = again;
            split = (entry & FORCED) != 0u || found.differ >= differing;
            half_shadow = found.half_shadow && !split && level > 1u && points == POINTS_BOTH;
            joined = true;
        }
    }
    if (gl_LocalInvocationIndex < PLACES) {
        sub_light[sub] = light_sum;
        sub_there[sub] = s.there ? 1u : 0u;
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        if (level == 1u)
            keep_pixels(at, split);
        else if (split)
            split_fragment(at, found.twice);
        else
            keep_fragment(at, entry);
        uint there = sub_there[0] + sub_there[1] + sub_there[2] + sub_there[3];
        counter_add(COUNT_SAMPLES, there);
        counter_add(COUNT_EVALUATIONS, there * light_count);
    }
    count_rays(rays);
}
