// compare.glsl: what four sub-fragments see, bit by bit (3.1.2) and by number (3.1.3).
#ifndef COMPARE_GLSL
#define COMPARE_GLSL

uvec2 sub_at(uint sub) // of the four around the fragment: each a neighbour of the one before
{
    return uvec2(sub == 1u || sub == 2u, sub >= 2u);
}

struct Found {
    uint differ; // bits, most of all lights
    uint twice;  // sub-fragments on a steep gradient
    uint lit;    // lights of which something is visible from one of them: bit number & 31
};

// seen: bits of the four for one light. steepest: the largest gradient. Returns whether some of
// the light is visible, but not all.
bool compare(uint light, bool joined, uint seen[4], inout Found found, out uint steepest)
{
    uint all = 0xffffu, any = 0u;
    steepest = 0u;
    for (uint i = 0u; i < 4u; i++) {
        uint next = seen[(i + 1u) & 3u];
        all &= seen[i];
        any |= seen[i];
        uint gradient = uint(abs(bitCount(seen[i]) - bitCount(next)));
        steepest = max(steepest, gradient);
        if (gradient > steep)
            found.twice |= 1u << i | 1u << ((i + 1u) & 3u);
    }
    bool part = any != 0u && all != 0xffffu;
    uint differ = joined && part ? 16u : joined ? 0u : bitCount(any & ~all);
    found.differ = max(found.differ, differ);
    found.lit |= any != 0u ? 1u << (light & 31u) : 0u;
    return part;
}

#endif
