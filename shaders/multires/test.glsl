// test.glsl: sub-fragment visibility tests (3.1.2) and gradient-aware refinement (3.1.3) of the
// fragments of one level. Four sub-fragments, 16 rays each to the same points of a light: where
// their bits differ the fragment is split. Two sub-fragments that follow each other around the
// fragment and whose numbers of visible points differ by more than `steep` are both split once
// more. Where nothing is visible from any of the four, nothing differs, and the fragment is dark,
// unless something is visible from its corners: then it is split. What was seen is kept as irradiance: of the sub-fragments of a final fragment, and of pixels.
//
// Joined: the four look at 16 other points each, and share what they see of the 64. That is how
// `points` has it of final fragments, which are traced a second round, and of the
// four pixels of level 1, unless they are of several surfaces or the shadow is steep: then each
// pixel in half shadow looks at the other 48 points itself.
//
// A dispatch does some of the lights, and one round or both: what is known is kept in between.
#ifndef TEST_GLSL
#define TEST_GLSL

#include "fragments.glsl"
#include "visibility.glsl"
#include "compare.glsl"
#include "outcome.glsl"
#include "lobe.glsl"

layout(local_size_x = 64) in; // 16 fragments of four sub-fragments

layout(set = 0, binding = 13, std430) buffer Kept { uvec4 kept[]; }; // two a sub-fragment

const uint QUAD_STEEP = 3u; // a gradient above it: four pixels do not share

shared uint sub_bits[64];
shared vec2 sub_weights[64];

struct Sub {
    Found found;
    vec3 light;
    float half_light; // what lights in half shadow would give without
    bool own;         // it looked at all points of one of them
};

// One light, from this invocation's sub-fragment, in uniform control flow.
void add_light(uint light, bool joined, bool may_own, bool one_surface, Surface s, inout Sub sub,
               inout uint rays)
{
    uint mine = gl_LocalInvocationIndex, first = mine & ~3u, bits = 0u, steepest = 0u;
    float form = s.there ? form_before_test(light, s) : 0.0;
    vec2 own = vec2(0.0), together = vec2(0.0);
    bool goes_on = form > 0.0, part = false, shares = joined;
    for (uint k = 0u; k < (may_own ? 4u : 1u); k++) {
        uint more = goes_on ? see_set(light, s, (joined ? mine : 0u) + k & 3u, own, rays) : 0u;
        if (k > 0u)
            continue;
        bits = more;
        sub_bits[mine] = bits;
        sub_weights[mine] = own;
        barrier();
        uint seen[4];
        for (uint i = 0u; i < 4u; i++) {
            seen[i] = sub_bits[first + i];
            together += sub_weights[first + i];
        }
        barrier();
        part = compare(light, joined, seen, sub.found, steepest);
        shares = joined && !(may_own && (!one_surface || steepest > QUAD_STEEP));
        // to the other points where some of what the four looked at is seen, but not all: a pixel
        // that saw nothing of its own may be beside one that did
        goes_on = !shares && part;
        sub.own = sub.own || (may_own && goes_on);
    }
    own = shares ? together : own;
    form = s.there ? form_after_test(light, s, form, own.x, own.y) : 0.0;
    vec3 open = areas[light].exitance.rgb * form;
    sub.light += own.x > 0.0 ? open * (own.x / own.y) : vec3(0.0);
    sub.half_light += part ? open.r + open.g + open.b : 0.0;
}

void finish(uint entry, uvec2 at, bool taken, bool there, Sub sub)
{
    uint mine = gl_LocalInvocationIndex, what = there ? SUB_THERE : 0u;
    bool split = (entry & FORCED) != 0u || sub.found.differ >= differing;
    bool shares = points == POINTS_BOTH && !sub.own
                  && 2.0 * sub.half_light > sub.light.r + sub.light.g + sub.light.b;
    sub_light[mine] = vec4(sub.light, shares ? -sub.half_light : PART);
    sub_what[mine] = what | (sub.own ? SUB_OWN : 0u);
    barrier();
    if ((mine & 3u) == 0u && taken) {
        if (level == 1u)
            keep_pixels(mine, at, split);
        else if (split)
            split_fragment(at, sub.found.twice);
        else
            keep_fragment(mine, at, entry);
    }
}

void main()
{
    uint mine = gl_LocalInvocationIndex, entry, rays = 0u;
    uint rounds = points == POINTS_BOTH && level > 1u ? 2u : 1u;
    bool taken = take_fragment(level, mine / 4u, entry);
    uvec2 at = unpack_fragment(entry);
    uint slot = (gl_WorkGroupID.y * 32768u + gl_WorkGroupID.x) * 64u + mine;
    Surface s = surface_at(fragment_pixel(level - 1u, at * 2u + sub_at(mine & 3u)));
    bool there = s.there && taken, one_surface = taken && pyramid[pyramid_index(level, at)] <= 1.0;
    Surface corner = surface_at(ivec2((at << level) + ((1u << level) - 1u) * sub_at(mine & 3u)));
    Sub sub = Sub(Found(0u, 0u, 0u), vec3(0.0), 0.0, false);
    if (first_light + first_round > 0u && taken) {
        uvec4 bits = kept[2u * slot + 1u];
        vec4 light = uintBitsToFloat(kept[2u * slot]);
        sub = Sub(Found(bits.x, bits.y, bits.z), light.rgb, light.a, bits.w != 0u);
    }
    uint count = last_light - first_light, turns = count * (last_round - first_round), i = 0u;
    for (; i < turns; i++) {
        uint round = first_round + i / count, light = first_light + i % count;
        bool joined = round > 0u || (points == POINTS_APART && one_surface)
                      || (points == POINTS_BOTH && level == 1u);
        bool dark = round > 0u && (sub.found.lit >> (light & 31u) & 1u) == 0u;
        Surface from = s;
        if (dark)
            from = corner;
        from.there = there && (round == 0u || sub.found.differ < differing);
        if (round > 0u && light == 0u) { // only what the second round sees counts
            sub.light = vec3(0.0);
            sub.half_light = 0.0;
        }
        Sub before = sub;
        add_light(light, joined, points == POINTS_BOTH && level == 1u, one_surface, from, sub, rays);
        bool lit = dark && sub.found.lit != before.found.lit;
        if (dark)
            sub = before;
        if (round > 0u)
            sub.found = before.found;
        sub.found.differ = lit ? 16u : sub.found.differ;
    }
    trace_gave_up = trace_gave_up || i < turns;
    if (last_light == light_count && last_round == rounds) {
        finish(entry, at, taken, there, sub);
        counter_add_group(COUNT_SAMPLES, there ? 1u : 0u);
        counter_add_group(COUNT_EVALUATIONS, there ? light_count : 0u);
    } else if (taken) {
        kept[2u * slot] = floatBitsToUint(vec4(sub.light, sub.half_light));
        kept[2u * slot + 1u] =
            uvec4(sub.found.differ, sub.found.twice, sub.found.lit, sub.own ? 1u : 0u);
    }
    count_rays(rays);
}

#endif
