// quad.glsl: four pixels that look at 16 points of a light each and share what they see of the 64,
// unless more would be lost than is worth it: then each looks itself at the points beside which the
// others saw a change, and takes the rest from them.
#ifndef QUAD_GLSL
#define QUAD_GLSL

#include "changes.glsl"

// The four do not share a light that is worth more where they are of several surfaces, or where it
// is worth more over the steepest gradient between them plus one.
const float QUAD_EDGE = 0.25;
const float QUAD_STEEP = 3.1;
// A bit in 64 of a light that is worth more shows: all points are looked at.
const float QUAD_BRIGHT = 3.0;

// Looks at the points on the squares that are left.
uvec2 look_at(uint light, Surface s, uvec2 left, uvec2 board, inout uint rays)
{
    while (any(notEqual(left, uvec2(0u)))) {
        uint word = left.x != 0u ? 0u : 1u;
        uint square = findLSB(left[word]), bit = 1u << square;
        uint point = point_on(32u * word + square);
        left[word] &= ~bit;
        board[word] &= ~bit;
        if (area_weight(light, point, s) > 0.0) {
            rays++;
            board[word] |= area_sees(light, point, s) ? bit : 0u;
        }
    }
    trace_gave_up = trace_gave_up || any(notEqual(left, uvec2(0u)));
    return board;
}

// Weights of what is visible by a board, and of all.
vec2 weigh(uint light, Surface s, uvec2 board)
{
    vec2 weights = vec2(0.0);
    for (uint i = 0u; i < AREA_POINTS; i++) {
        float weight = area_weight(light, point_on(i), s);
        weights += (board[i >> 5] >> (i & 31u) & 1u) != 0u ? vec2(weight) : vec2(0.0, weight);
    }
    return weights;
}

// The bits of the four sets of points, on the board.
uvec2 board_of(uint sets[4])
{
    uvec2 board = uvec2(0u);
    for (uint i = 0u; i < 32u; i++) {
        uint low = point_on(i), high = point_on(i + 32u);
        board.x |= (sets[low >> 4] >> (low & 15u) & 1u) << i;
        board.y |= (sets[high >> 4] >> (high & 15u) & 1u) << i;
    }
    return board;
}

// One light, from this invocation's pixel, in uniform control flow: the set of 16, and where the
// pixel is alone twice what is beside a change.
void quad_light(uint light, bool one_surface, Surface s, inout Sub sub, inout uint rays)
{
    uint mine = gl_LocalInvocationIndex & 3u;
    float form = s.there ? form_before_test(light, s) : 0.0;
    vec2 weights = vec2(0.0);
    uint bits = form > 0.0 ? see_set(light, s, mine, weights, rays) : 0u;
    Seen seen = share(bits, weights, worth_of(light, form));
    bool part = compare(light, true, seen, sub.found);
    float steepness = float(steepest_of(seen) + 1u) * seen.worth;
    bool alone = part && form > 0.0
                 && ((!one_surface && seen.worth > QUAD_EDGE) || steepness > QUAD_STEEP);
    if (alone) {
        bool at_all = !one_surface || seen.worth > QUAD_BRIGHT;
        uvec2 board = board_of(seen.bits), looked = squares_of(mine);
        for (uint turn = 0u; turn < 2u; turn++) {
            uvec2 left = (at_all ? uvec2(0xffffffffu) : beside_changes(board)) & ~looked;
            board = look_at(light, s, left, board, rays);
            looked |= left;
        }
        weights = weigh(light, s, board);
        sub.own = true;
    } else if (one_surface) {
        weights = seen.together;
    }
    keep_light(light, part, form, weights, s, sub);
}

#endif
