// test.glsl: sub-fragment visibility tests (3.1.2) and gradient-aware refinement (3.1.3) of the
// fragments of one level. Four sub-fragments, 16 rays each to the same points of a light: where
// their bits differ by more than is tolerated the fragment is split. Two sub-fragments that follow
// each other around the fragment and whose numbers of visible points differ by more than `steep`
// are both split once more. What was seen is kept as irradiance: of the sub-fragments of a final
// fragment, and of pixels.
//
// By `points`, final fragments are looked at once more, by other points: a light that is worth much
// by all 64 from each of the four, whose bits are compared again; others by 16 each, of which they
// share what they see; and lights of which nothing was visible from the corners, and the fragment
// is split if something is. Four pixels share as well, see quad.glsl.
//
// A dispatch does some of the lights, and one round or both: what is known is kept in between.
#ifndef TEST_GLSL
#define TEST_GLSL

#include "fragments.glsl"
#include "visibility.glsl"
#include "compare.glsl"
#include "outcome.glsl"
#include "lobe.glsl"
#include "queue.glsl"
#include "spot.glsl"

layout(local_size_x = 64) in; // 16 fragments of four sub-fragments

layout(set = 0, binding = 13, std430) buffer Kept { uvec4 kept[]; }; // two a sub-fragment

struct Sub {
    Found found;
    vec3 light;
    float half_light; // what lights in half shadow would give without
    bool own;         // it looked at all points of one of them
    float local;      // irradiance around over the image's mean, nearly
};

#include "share.glsl"
#ifdef MULTIRES_QUADS
#include "quad.glsl"
#else
#include "sub.glsl"
#endif

void finish(uint entry, uvec2 at, bool taken, bool there, Sub sub)
{
    uint mine = gl_LocalInvocationIndex, what = there ? SUB_THERE : 0u;
    bool split = (entry & FORCED) != 0u || sub.found.differ > tolerance * allowance(sub.local, DIM);
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

// Only what the second round sees counts; what the first saw tells how bright it is here, to this
// fragment and to those that it is split into.
void start_again(uvec2 at, bool taken, bool there, inout Sub sub)
{
    float local = share_light(sub.light, there);
    if (taken && (gl_LocalInvocationIndex & 3u) == 0u)
        illumination[fragment_index(level, at)] = vec4(local, 1.0, 0.0, NOTHING);
    sub.local = over_mean(local);
    sub.light = vec3(0.0);
    sub.half_light = 0.0;
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
    Sub sub = Sub(Found(0.0, 0u, 0u), vec3(0.0), 0.0, false, taken ? local_estimate(at) : 1.0);
    if (first_light + first_round > 0u && taken) {
        uvec4 bits = kept[2u * slot + 1u];
        vec4 light = uintBitsToFloat(kept[2u * slot]);
        sub = Sub(Found(uintBitsToFloat(bits.x), bits.y, bits.z), light.rgb, light.a,
                  bits.w >> 31 != 0u, abs(uintBitsToFloat(bits.w)));
    }
    s.there = there;
    corner.there = corner.there && taken;
    uint count = last_light - first_light, turns = count * (last_round - first_round), i = 0u;
    for (; i < turns; i++) {
        uint round = first_round + i / count, light = first_light + i % count;
        if (round > 0u && light == 0u)
            start_again(at, taken, there, sub);
        look_at_light(light, round, one_surface, s, corner, sub, rays);
    }
    trace_gave_up = trace_gave_up || i < turns;
    if (last_light == light_count && last_round == rounds) {
        finish(entry, at, taken, there, sub);
        counter_add_group(COUNT_SAMPLES, there ? 1u : 0u);
        counter_add_group(COUNT_EVALUATIONS, there ? light_count : 0u);
    } else if (taken) {
        kept[2u * slot] = floatBitsToUint(vec4(sub.light, sub.half_light));
        kept[2u * slot + 1u] = uvec4(floatBitsToUint(sub.found.differ), sub.found.twice,
                                     sub.found.lit,
                                     floatBitsToUint(sub.own ? -sub.local : sub.local));
    }
    count_rays(rays);
}

#endif
