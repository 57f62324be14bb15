// compare.glsl: what four sub-fragments see, bit by bit (3.1.2) and by number (3.1.3). A bit counts
// for what a sixteenth of the light is worth there.
#ifndef COMPARE_GLSL
#define COMPARE_GLSL

uvec2 sub_at(uint sub) // of the four around the fragment: each a neighbour of the one before
{
    return uvec2(sub == 1u || sub == 2u, sub >= 2u);
}

struct Found {
    float differ; // of all lights, over the image's mean irradiance
    uint twice;   // sub-fragments on a steep gradient
    uint lit;     // lights of which something is visible from one of them: bit number & 31
};

struct Seen { // of one light, by the four
    uint bits[4];
    vec2 together; // weights of what is visible, and of all
    float worth;   // of the light where it is worth most, see worth_of
};

const float TOO_MUCH = 1e9; // of Found.differ

uint steepest_of(Seen seen)
{
    uint steepest = 0u;
    for (uint i = 0u; i < 4u; i++)
        steepest = max(steepest,
                       uint(abs(bitCount(seen.bits[i]) - bitCount(seen.bits[(i + 1u) & 3u]))));
    return steepest;
}

// joined: of 16 points each. Returns whether some of the light is visible, but not all.
bool compare(uint light, bool joined, Seen seen, inout Found found)
{
    uint all = 0xffffu, any = 0u;
    for (uint i = 0u; i < 4u; i++) {
        uint next = seen.bits[(i + 1u) & 3u];
        all &= seen.bits[i];
        any |= seen.bits[i];
        uint gradient = uint(abs(bitCount(seen.bits[i]) - bitCount(next)));
        if (gradient > steep && float(gradient) * seen.worth > 16.0 * tolerance)
            found.twice |= 1u << i | 1u << ((i + 1u) & 3u);
    }
    bool part = any != 0u && all != 0xffffu;
    uint differ = joined && part ? 16u : joined ? 0u : bitCount(any & ~all);
    found.differ += differ >= differing ? float(differ) * seen.worth / 16.0 : 0.0;
    found.lit |= any != 0u ? 1u << (light & 31u) : 0u;
    return part;
}

#endif
