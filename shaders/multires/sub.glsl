// sub.glsl: one light, from one of four sub-fragments.
#ifndef SUB_GLSL
#define SUB_GLSL

// A light that is worth more is looked at from the corners of fragments of 4 pixels, too.
const float CORNERS = 2.0;

// What differs between the four, which looked at the same points of a bright light or at 16 each,
// and the fragment's corners, which look at 16 each where `cornered`; over the mean irradiance. A
// bit of 64 counts twice as much: what these do not show is not looked for again.
float differ_again(bool bright, bool cornered, Seen seen, uvec2 at, float limit)
{
    uvec2 all = bright ? seen.all : seen.any;
    uint differ = count_squares(cornered ? (seen.any | at) & ~(all & at) : seen.any & ~all);
    int more = int(count_squares(at)) - int(count_squares(seen.any));
    if (bright)
        return differ >= differing ? float(differ) * seen.worth / 32.0 : 0.0;
    return cornered && float(abs(more)) * seen.worth > 64.0 * limit ? TOO_MUCH : 0.0;
}

// The first round, by the same 16 points, or joined: by 16 of 64 each. The second, unless the
// fragment is to be split already: from the four, for a bright light to all 64 points, and then from
// the corners.
void look_at_light(uint light, uint round, bool one_surface, Surface s, Surface corner,
                   inout Sub sub, inout uint rays)
{
    uint mine = gl_LocalInvocationIndex;
    bool again = round > 0u, joined = points == POINTS_APART && one_surface;
    float limit = tolerance * allowance(sub.local, DIM);
    bool goes_on = !again || sub.found.differ <= limit;
    bool dark = again && (sub.found.lit >> (light & 31u) & 1u) == 0u;
    float form = s.there && goes_on && !dark ? form_before_test(light, s) : 0.0;
    float worth = share_worth(worth_of(light, form));
    bool bright = again && worth > BRIGHT;
    bool cornered = goes_on && (dark || level > 2u || worth > CORNERS);
    uvec2 set = squares_of(mine & 3u);
    uvec2 squares = bright ? uvec2(0xffffffffu) : again || joined ? set : squares_of(0u);
    squares = form > 0.0 ? squares : uvec2(0u);
    bool uneven = points == POINTS_BOTH && !again && is_uneven(light, s, corner, form);
    Seen seen;
    for (uint turn = 0u; turn <= round; turn++) {
        Surface from = s;
        if (turn > 0u) {
            from = corner;
            bool looks = cornered && corner.there && area_form_factor(light, corner) > 0.0;
            squares = looks ? set : uvec2(0u);
        }
        vec2 weights;
        squares = facing(light, from, squares, weights.y);
        rays += count_squares(squares);
        queue_ask(from, squares);
        queue_trace(light);
        uvec2 board = queue_answer(mine);
        if (turn == 0u) {
            facing(light, s, board, weights.x);
            seen = share_seen(weights, worth);
            bool some = seen.any != uvec2(0u);
            bool part = again ? some && (bright ? seen.all : seen.any) != uvec2(0xffffffffu)
                              : compare(light, joined, seen, sub.found);
            if (some && uneven)
                sub.found.differ += TOO_MUCH;
            keep_light(light, part, form, bright || !(again || joined) ? weights : seen.together, s,
                       sub);
        } else {
            uint first = mine & ~3u;
            uvec2 at = queue_answer(first) | queue_answer(first + 1u) | queue_answer(first + 2u)
                       | queue_answer(first + 3u);
            float differ = differ_again(bright, cornered, seen, at, limit);
            sub.found.differ += !dark ? differ : at != uvec2(0u) ? TOO_MUCH : 0.0;
        }
        barrier();
    }
}

#endif
