// sub.glsl: one light, from one of four sub-fragments; test.glsl has the struct Sub.
#ifndef SUB_GLSL
#define SUB_GLSL

shared uint sub_bits[64];
shared vec3 sub_weights[64]; // z: worth

// What the four of this invocation's fragment see; in uniform control flow.
Seen share(uint bits, vec2 weights, float worth)
{
    uint mine = gl_LocalInvocationIndex, first = mine & ~3u;
    sub_bits[mine] = bits;
    sub_weights[mine] = vec3(weights, worth);
    barrier();
    Seen seen;
    seen.together = vec2(0.0);
    seen.worth = 0.0;
    for (uint i = 0u; i < 4u; i++) {
        seen.bits[i] = sub_bits[first + i];
        seen.together += sub_weights[first + i].xy;
        seen.worth = max(seen.worth, sub_weights[first + i].z);
    }
    barrier();
    return seen;
}

void keep_light(uint light, bool part, float form, vec2 weights, Surface s, inout Sub sub)
{
    float whole = s.there ? form_after_test(light, s, form, weights.x, weights.y) : 0.0;
    vec3 open = areas[light].exitance.rgb * whole;
    sub.light += weights.x > 0.0 ? open * (weights.x / weights.y) : vec3(0.0);
    sub.half_light += part ? open.r + open.g + open.b : 0.0;
}

// The first round, by the same 16 points; joined: by 16 of 64 each.
void test_light(uint light, bool joined, Surface s, inout Sub sub, inout uint rays)
{
    uint set = joined ? gl_LocalInvocationIndex & 3u : 0u;
    float form = s.there ? form_before_test(light, s) : 0.0;
    vec2 weights = vec2(0.0);
    uint bits = form > 0.0 ? see_set(light, s, set, weights, rays) : 0u;
    Seen seen = share(bits, weights, worth_of(light, form));
    bool part = compare(light, joined, seen, sub.found);
    keep_light(light, part, form, joined ? seen.together : weights, s, sub);
}

// What differs between the four, which looked at the same points of a bright light or at 16 each,
// and the fragment's corners, which look at 16 each where `cornered`; over the mean irradiance. A
// bit of 64 counts twice as much: what these do not show is not looked for again.
float differ_again(bool bright, bool cornered, float worth, uint any[4], uint all[4], uint at[4])
{
    uint differ = 0u;
    int more = 0;
    for (uint i = 0u; i < 4u; i++) {
        differ += bitCount((cornered ? any[i] | at[i] : any[i]) & ~(cornered ? all[i] & at[i] : all[i]));
        more += bitCount(at[i]) - bitCount(any[i]);
    }
    if (bright)
        return differ >= differing ? float(differ) * worth / 32.0 : 0.0;
    return cornered && float(abs(more)) * worth > 64.0 * tolerance ? TOO_MUCH : 0.0;
}

// The second round, unless the fragment is to be split already: from the four, which for a bright
// light is all 64 points, and from the corners.
void look_again(uint light, Surface s, Surface corner, inout Sub sub, inout uint rays)
{
    bool dark = (sub.found.lit >> (light & 31u) & 1u) == 0u, goes_on = sub.found.differ <= tolerance;
    bool cornered = goes_on && (dark || level > 2u), bright = false, some = false, whole = true;
    float form = goes_on && s.there && !dark ? form_before_test(light, s) : 0.0, worth = 0.0;
    vec2 weights = vec2(0.0), together = vec2(0.0);
    uint any[4], all[4], mine = gl_LocalInvocationIndex & 3u;
    // a turn to learn what the light is worth, four for the four, one for the corners
    for (uint turn = 0u; turn < 6u; turn++) {
        uint set = bright && turn < 5u ? turn - 1u : mine, bits = 0u;
        bool looks = form > 0.0 && (turn == 1u || (bright && turn > 1u));
        Surface from = s;
        if (turn == 5u) {
            from = corner;
            looks = cornered && corner.there && area_form_factor(light, corner) > 0.0;
        }
        vec2 seen_here = vec2(0.0);
        if (looks && turn > 0u)
            bits = see_set(light, from, set, seen_here, rays);
        weights += turn < 5u ? seen_here : vec2(0.0);
        Seen seen = share(bits, weights, worth_of(light, form));
        if (turn == 0u) {
            worth = seen.worth;
            bright = worth > BRIGHT;
        } else if (turn == 5u) {
            float differ = differ_again(bright, cornered, worth, any, all, seen.bits);
            bool lit = (seen.bits[0] | seen.bits[1] | seen.bits[2] | seen.bits[3]) != 0u;
            sub.found.differ += !dark ? differ : lit ? TOO_MUCH : 0.0;
        } else if (bright) {
            any[turn - 1u] = seen.bits[0] | seen.bits[1] | seen.bits[2] | seen.bits[3];
            all[turn - 1u] = seen.bits[0] & seen.bits[1] & seen.bits[2] & seen.bits[3];
        } else if (turn == 1u) {
            any = seen.bits;
            all = seen.bits;
            together = seen.together;
        }
    }
    for (uint i = 0u; i < 4u; i++) {
        some = some || any[i] != 0u;
        whole = whole && all[i] == 0xffffu;
    }
    keep_light(light, some && !whole, form, bright ? weights : together, s, sub);
}

#endif
