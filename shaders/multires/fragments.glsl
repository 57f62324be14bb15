// fragments.glsl: squares of 1, 2, 4, 8, 16 pixels a side, levels 0 to 4, and what is kept of
// each. Shared by multires and nichols.
#ifndef FRAGMENTS_GLSL
#define FRAGMENTS_GLSL

#include "../shadows/area.glsl"

layout(push_constant) uniform Push
{
    uvec2 tiles;          // of 16 pixels, in the image
    uint level;           // that this dispatch does
    uint differing;       // bits of visibility that make a fragment split
    uint steep;           // a gradient above it splits twice
    float plane_limit;    // of geometric discontinuity: pixels, see pyramids.comp,
    float normal_limit;   // and length of the diagonal of the box around the normals
    uint points;          // one of those below
    uint together;        // fragments that a work group of the next passes takes
    uint first_light, last_light; // of this dispatch, without the last
    uint first_round, last_round; // of test.comp, without the last
    float tolerance;      // what may differ in a fragment, over the image's mean irradiance
};
const uint POINTS_SAME = 0u;  // the same 16 of each light for all
const uint POINTS_BOTH = 1u;  // the same 16 for tests, all 64 split over four for irradiance
const uint POINTS_APART = 2u; // all 64 split over four for both

const uint TOP = 4u;

// What waits: list l of fragments of level l to be tested; list 0 of those that get more samples.
struct Work {
    uint groups[3]; // of an indirect dispatch
    uint count;     // 1 more than there are
};
const uint MEAN = TOP + 1u; // bits of the image's mean irradiance are groups[0] there
layout(set = 0, binding = 9, std430) buffer WorkBuffer { Work work[]; };
layout(set = 0, binding = 10, std430) buffer Lists { uint lists[]; };

// Per fragment of levels 1 to 4: discontinuity, see pyramids.comp.
layout(set = 0, binding = 11, std430) buffer Pyramid { float pyramid[]; };

// Irradiance per fragment of every level; w: one of these.
layout(set = 0, binding = 12, std430) buffer Illumination { vec4 illumination[]; };
const float NOTHING = 0.0; // x: what is estimated there, the mean of the channels; y: 1 if it is
const float FINAL = 1.0;  // a fragment that is not refined
const float SAMPLE = 2.0; // an additional sample, a pixel of a fragment of level 3 or 4
const float PART = 3.0;   // a sub-fragment of a fragment that is not refined
const float DARK = 4.0;   // final, and faces away from every light
// Less than 0: PART, and half shadow that it shares with the other three: upsampled from its
// neighbours. Minus what the lights in half shadow would give without, the sum of the channels.

uint level_base(uint l) // of a level's fragments in the buffer of all levels
{
    uint before = l == 0u ? 0u : l == 1u ? 256u : l == 2u ? 320u : l == 3u ? 336u : 340u;
    return before * tiles.x * tiles.y;
}

uint fragment_index(uint l, uvec2 at)
{
    return level_base(l) + at.y * (tiles.x << (TOP - l)) + at.x;
}

uint pyramid_index(uint l, uvec2 at)
{
    return fragment_index(l, at) - level_base(1u);
}

const uint FORCED = 0x80000000u; // split whatever is seen

uint pack_fragment(uvec2 at, uint flags)
{
    return at.x | at.y << 14 | flags;
}

uvec2 unpack_fragment(uint entry)
{
    return uvec2(entry & 0x3fffu, entry >> 14 & 0x3fffu);
}

uint list_base(uint l)
{
    return l == 0u ? 85u * tiles.x * tiles.y : level_base(l) - level_base(1u);
}

// Neighbours side by side: their rays are traced together. As many groups as the entries need, in
// rows of 32768.
void push_fragments(uint list, uint count, uint entries[4])
{
    uint slot = atomicAdd(work[list].count, count) - 1u;
    for (uint i = 0u; i < count; i++)
        lists[list_base(list) + slot + i] = entries[i];
    uint group = (slot + count - 1u) / together;
    atomicMax(work[list].groups[0], min(group + 1u, 32768u));
    atomicMax(work[list].groups[1], group / 32768u + 1u);
}

void push_fragment(uint list, uint entry)
{
    push_fragments(list, 1u, uint[4](entry, 0u, 0u, 0u));
}

uvec2 sub_at(uint sub) // of the four around the fragment: each a neighbour of the one before
{
    return uvec2(sub == 1u || sub == 2u, sub >= 2u);
}

// All four parts.
void push_parts(uint list, uvec2 at)
{
    uint parts[4];
    for (uint i = 0u; i < 4u; i++)
        parts[i] = pack_fragment(at * 2u + sub_at(i), 0u);
    push_fragments(list, 4u, parts);
}

// A fragment of this group; false where there is none left.
bool take_fragment(uint list, uint which, out uint entry)
{
    uint slot = (gl_WorkGroupID.y * 32768u + gl_WorkGroupID.x) * together + which;
    bool there = slot + 1u < work[list].count;
    entry = there ? lists[list_base(list) + slot] : 0u;
    return there;
}

// The pixel that stands for a fragment.
ivec2 fragment_pixel(uint l, uvec2 at)
{
    return ivec2(at << l) + (l == 0u ? 0 : 1 << (l - 1u));
}

#endif
