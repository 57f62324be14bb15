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
#include "fragments.glsl"
#include "visibility.glsl"
#include "compare.glsl"

layout(local_size_x = 64) in; // 16 fragments of four sub-fragments

shared uint sub_bits[64];
shared vec2 sub_weights[64];
shared vec3 sub_light[64];
shared uint sub_there[64];

// Irradiance of the sub-fragment of this invocation, in uniform control flow.
vec3 light_sub(bool joined, bool one_surface, Surface s, inout Found found, inout uint rays)
{
    uint mine = gl_LocalInvocationIndex, first = mine & ~3u, light = 0u;
    vec3 sum = vec3(0.0);
    for (; light < light_count; light++) {
        float form = s.there ? area_form_factor(light, s) : 0.0;
        vec2 own = vec2(0.0);
        uint set = joined ? mine & 3u : 0u;
        uint bits = form > 0.0 ? see_set(light, s, set, own, rays) : 0u;
        sub_bits[mine] = bits;
        sub_weights[mine] = own;
        barrier();
        uint seen[4];
        vec2 together = vec2(0.0);
        for (uint i = 0u; i < 4u; i++) {
            seen[i] = sub_bits[first + i];
            together += sub_weights[first + i];
        }
        barrier();
        bool is_steep = compare(joined, seen, found);
        bool alone = points == POINTS_BOTH && level == 1u && (!one_surface || is_steep);
        // the other points where some of these are seen, but not all
        for (uint k = 1u; k < 4u && alone && in_part(bits); k++)
            see_set(light, s, set + k & 3u, own, rays);
        own = joined && !alone ? together : own;
        if (own.x > 0.0)
            sum += areas[light].exitance.rgb * (form * own.x / own.y);
    }
    trace_gave_up = trace_gave_up || light < light_count;
    return sum;
}

void keep_pixels(uint first, uvec2 at, bool split)
{
    uint kept = 0u;
    for (uint i = 0u; i < 4u; i++) {
        if (sub_there[first + i] == 0u)
            continue;
        uint index = fragment_index(0u, at * 2u + sub_at(i));
        illumination[index] = vec4(sub_light[first + i], split ? FINAL : PART);
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

void keep_fragment(uint first, uvec2 at, uint entry)
{
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < 4u; i++) {
        sum += sub_light[first + i];
        illumination[fragment_index(level - 1u, at * 2u + sub_at(i))] = vec4(sub_light[first + i], PART);
    }
    illumination[fragment_index(level, at)] = vec4(0.25 * sum, FINAL);
    if (level > 2u)
        push_fragment(0u, entry | level << 28);
    counter_add(COUNT_FRAGMENTS + level, 1u);
}

void main()
{
    uint mine = gl_LocalInvocationIndex, sub = mine & 3u, first = mine & ~3u, entry, rays = 0u;
    bool taken = take_fragment(level, mine / 4u, entry);
    uvec2 at = unpack_fragment(entry);
    Surface s = surface_at(fragment_pixel(level - 1u, at * 2u + sub_at(sub)));
    s.there = s.there && taken;
    bool there = s.there, one_surface = taken && pyramid[pyramid_index(level, at)] <= 1.0;
    bool joined = (points == POINTS_APART && one_surface) || (points == POINTS_BOTH && level == 1u);
    Found found = Found(0u, 0u, false), again = found;
    vec3 light_sum = light_sub(joined, one_surface, s, found, rays);
    bool split = (entry & FORCED) != 0u || found.differ >= differing;
    if (level > 1u && points == POINTS_BOTH) { // for all of the group: the others trace nothing
        s.there = s.there && found.half_shadow && !split;
        vec3 finer = light_sub(true, true, s, again, rays);
        light_sum = s.there ? finer : light_sum;
    }
    sub_light[mine] = light_sum;
    sub_there[mine] = there ? 1u : 0u;
    barrier();
    if (sub == 0u && taken) {
        if (level == 1u)
            keep_pixels(first, at, split);
        else if (split)
            split_fragment(at, found.twice);
        else
            keep_fragment(first, at, entry);
    }
    counter_add_group(COUNT_SAMPLES, there ? 1u : 0u);
    counter_add_group(COUNT_EVALUATIONS, there ? light_count : 0u);
    count_rays(rays);
}
