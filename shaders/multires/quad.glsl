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

shared uvec2 quad_boards[64];

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

// Weights of what is visible by a board, and of all: on the squares that count.
vec2 weigh(uint light, Surface s, uvec2 board, uvec2 count)
{
    vec2 weights = vec2(0.0);
    for (uint i = 0u; i < AREA_POINTS; i++) {
        bool counts = (count[i >> 5] >> (i & 31u) & 1u) != 0u;
        float weight = counts ? area_weight(light, point_on(i), s) : 0.0;
        weights += (board[i >> 5] >> (i & 31u) & 1u) != 0u ? vec2(weight) : vec2(0.0, weight);
    }
    return weights;
}

// One light, from this invocation's pixel, in uniform control flow: the set of 16, and where the
// pixel is alone twice what is beside a change.
void quad_light(uint light, bool one_surface, Surface s, inout Sub sub, inout uint rays)
{
    uint mine = gl_LocalInvocationIndex, first = mine & ~3u;
    float form = s.there ? form_before_test(light, s) : 0.0;
    uvec2 board = uvec2(0u), looked = uvec2(0u), left = squares_of(mine & 3u), own = left;
    bool alone = false, at_all = false, part = false;
    for (uint turn = 0u; turn < 3u; turn++) {
        if (form > 0.0 && (turn == 0u || alone)) {
            board = look_at(light, s, left, board, rays);
            looked |= left;
        }
        if (turn == 0u) {
            // as numbers: the bits are not of the same points
            uint number = uint(bitCount(board.x) + bitCount(board.y));
            quad_boards[mine] = board;
            Seen seen = share((1u << number) - 1u, vec2(0.0), worth_of(light, form));
            part = compare(light, true, seen, sub.found);
            float steepness = float(steepest_of(seen) + 1u) * seen.worth;
            alone = part && ((!one_surface && seen.worth > QUAD_EDGE) || steepness > QUAD_STEEP);
            at_all = !one_surface || seen.worth > QUAD_BRIGHT;
            for (uint i = 0u; i < 4u; i++)
                board |= quad_boards[first + i];
        }
        left = (at_all ? uvec2(0xffffffffu) : beside_changes(board)) & ~looked;
    }
    sub.own = sub.own || (alone && form > 0.0);
    vec2 weights = vec2(0.0);
    if (form > 0.0)
        weights = weigh(light, s, board, one_surface || alone ? uvec2(0xffffffffu) : own);
    keep_light(light, part, form, weights, s, sub);
}

#endif
