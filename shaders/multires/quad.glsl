// quad.glsl: four pixels that look at 16 points of a light each and share what they see of the 64,
// unless more would be lost than is worth it: then each looks itself at the points beside which the
// others saw a change, and takes the rest from them.
#ifndef QUAD_GLSL
#define QUAD_GLSL

// The four do not share a light that is worth more where they are of several surfaces, or where it
// is worth more over the steepest gradient between them plus one, less in shadow.
const float QUAD_EDGE = 0.25;
const float QUAD_STEEP = 3.95;
const float QUAD_DIM = 0.3;
// A bit in 64 of a light that is worth more shows: all points are looked at, even where the four
// saw all of 64.
const float QUAD_BRIGHT = 3.0;

bool stands_alone(bool one_surface, bool part, Seen seen, float local)
{
    if (!part)
        return seen.any != uvec2(0u) && seen.worth > QUAD_BRIGHT;
    uint steepest = max(max(step_after(seen, 0u), step_after(seen, 1u)),
                        max(step_after(seen, 2u), step_after(seen, 3u)));
    return (!one_surface && seen.worth > QUAD_EDGE)
           || float(steepest + 1u) * seen.worth > QUAD_STEEP * allowance(local, QUAD_DIM);
}

// From this invocation's pixel: the set of 16, and where the pixel is alone twice what is beside a
// change.
void look_at_light(uint light, uint round, bool one_surface, Surface s, Surface corner,
                   inout Sub sub, inout uint rays)
{
    uint mine = gl_LocalInvocationIndex;
    float form = s.there ? form_before_test(light, s) : 0.0;
    float worth = share_worth(worth_of(light, form));
    uvec2 left = form > 0.0 ? squares_of(mine & 3u) : uvec2(0u), looked = left, board = uvec2(0u);
    bool part = false, alone = false, at_all = false;
    vec2 weights = vec2(0.0);
    for (uint turn = 0u; turn < 3u; turn++) {
        if (turn > 0u) {
            left = at_all ? uvec2(0xffffffffu) : beside_changes(board);
            left = alone ? left & ~looked : uvec2(0u);
            looked |= left;
        }
        float weight;
        uvec2 faced = facing(light, s, left, weight);
        rays += count_squares(faced);
        queue_ask(s, faced);
        queue_trace(light);
        board = (board & ~left) | queue_answer(mine);
        if (turn == 0u) {
            facing(light, s, board, weights.x);
            weights.y = weight;
            Seen seen = share_seen(weights, worth);
            part = compare(light, true, seen, sub.found);
            alone = form > 0.0 && stands_alone(one_surface, part, seen, sub.local);
            at_all = !one_surface || worth > QUAD_BRIGHT;
            board = alone ? seen.any : board;
            weights = one_surface ? seen.together : weights;
        }
        barrier();
    }
    if (alone) {
        weights = weigh(light, s, board);
        sub.own = true;
    }
    keep_light(light, part, form, weights, s, sub);
}

#endif
