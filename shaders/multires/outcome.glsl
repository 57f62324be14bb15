// outcome.glsl: what becomes of a fragment after its test: it is split, or it is final and what its
// sub-fragments saw is kept as irradiance. Called by the first of its four invocations.
#ifndef OUTCOME_GLSL
#define OUTCOME_GLSL

const uint SUB_THERE = 1u;  // has a surface
const uint SUB_OWN = 2u;    // a pixel that looked at all points itself
shared uint sub_what[64];
shared vec4 sub_light[64]; // w: PART, or less than 0

// Four pixels. Those that looked at all points themselves are fragments of level 0, the others are
// one of level 1. By 16 points alone a split makes four fragments of what is known already.
void keep_pixels(uint first, uvec2 at, bool split)
{
    uint fine = 0u, coarse = 0u;
    for (uint i = 0u; i < 4u; i++) {
        uint what = sub_what[first + i];
        if ((what & SUB_THERE) == 0u)
            continue;
        bool own = points == POINTS_SAME ? split : (what & SUB_OWN) != 0u;
        fine += own ? 1u : 0u;
        coarse = own ? coarse : 1u;
        illumination[fragment_index(0u, at * 2u + sub_at(i))] =
            vec4(sub_light[first + i].rgb, own ? FINAL : sub_light[first + i].w);
    }
    if (fine > 0u)
        counter_add(COUNT_FRAGMENTS, fine);
    if (coarse > 0u)
        counter_add(COUNT_FRAGMENTS + 1u, coarse);
}

void split_fragment(uvec2 at, uint twice)
{
    uint parts[4], count = 0u;
    for (uint i = 0u; i < 4u; i++) {
        uvec2 sub = at * 2u + sub_at(i);
        bool again = (twice >> i & 1u) != 0u;
        if (!again || level == 2u)
            parts[count++] = pack_fragment(sub, again ? FORCED : 0u);
        else
            push_parts(level - 2u, sub);
    }
    if (count > 0u)
        push_fragments(level - 1u, count, parts);
}

void keep_fragment(uint first, uvec2 at, uint entry)
{
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < 4u; i++) {
        vec4 light = sub_light[first + i];
        sum += light.rgb;
        illumination[fragment_index(level - 1u, at * 2u + sub_at(i))] =
            vec4(light.rgb, level == 2u ? light.w : PART);
    }
    illumination[fragment_index(level, at)] = vec4(0.25 * sum, FINAL);
    if (level > 2u)
        push_fragment(0u, entry | level << 28);
    counter_add(COUNT_FRAGMENTS + level, 1u);
}

#endif
