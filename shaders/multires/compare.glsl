// compare.glsl: what four sub-fragments see, bit by bit (3.1.2) and by number (3.1.3). A bit counts
// for what a sixteenth of the light is worth there.
#ifndef COMPARE_GLSL
#define COMPARE_GLSL

struct Found {
    float differ; // of all lights, over the image's mean irradiance
    uint twice;   // sub-fragments on a steep gradient
    uint lit;     // lights of which something is visible from one of them: bit number & 31
};

struct Seen { // of one light, by the four
    uint counts[4];  // of visible points
    uvec2 any, all;  // squares that one of them sees, and that each does
    vec2 together;   // weights of what is visible, and of all
    float worth;     // of the light where it is worth most, see worth_of
};

const float TOO_MUCH = 1e9; // of Found.differ

uint step_after(Seen seen, uint sub) // to the next one around
{
    return uint(abs(int(seen.counts[sub]) - int(seen.counts[(sub + 1u) & 3u])));
}

// Of 16 points from each. joined: other ones. Returns whether some of the light is visible, but not
// all.
bool compare(uint light, bool joined, Seen seen, inout Found found)
{
    bool whole = true, some = seen.any != uvec2(0u);
    for (uint i = 0u; i < 4u; i++) {
        uint gradient = step_after(seen, i);
        whole = whole && seen.counts[i] == AREA_FEW;
        if (gradient > steep && float(gradient) * seen.worth > float(AREA_FEW) * tolerance)
            found.twice |= 1u << i | 1u << ((i + 1u) & 3u);
    }
    bool part = some && !whole;
    uint differ = joined ? part ? AREA_FEW : 0u : count_squares(seen.any & ~seen.all);
    found.differ += differ >= differing ? float(differ) * seen.worth / float(AREA_FEW) : 0.0;
    found.lit |= some ? 1u << (light & 31u) : 0u;
    return part;
}

#endif
