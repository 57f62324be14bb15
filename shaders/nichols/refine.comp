#version 450
#extension GL_GOOGLE_include_directive : require
// refine.comp: fragments of one level are split in four where the bits of visibility differ
// between them and the neighbours of their level, 3 x 3.
#include "../multires/fragments.glsl"
#include "bits.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uint count_differing(ivec2 at, ivec2 size, uint light)
{
    uvec2 both = uvec2(0xffffffffu), either = uvec2(0u);
    for (int i = 0; i < 9; i++) {
        ivec2 other = at + ivec2(i % 3, i / 3) - 1;
        if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, size)))
            continue;
        uint kept = fragment_index(level, uvec2(other)) * (light_count + 1u);
        if (visible[kept].x == 0u)
            continue;
        both &= visible[kept + 1u + light];
        either |= visible[kept + 1u + light];
    }
    ivec2 differ = bitCount(either & ~both);
    return uint(differ.x + differ.y);
}

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = ivec2(tiles << (TOP - level));
    uint kept = all(lessThan(at, size)) ? fragment_index(level, uvec2(at)) : 0u;
    bool traced = all(lessThan(at, size)) && visible[kept * (light_count + 1u)].x != 0u;
    uint differ = 0u;
    for (uint light = 0u; traced && light < light_count; light++)
        differ = max(differ, count_differing(at, size, light));
    bool final = traced && differ < differing;
    if (final)
        illumination[kept].w = FINAL;
    if (traced && !final)
        push_parts(level - 1u, uvec2(at));
    counter_add_group(COUNT_FRAGMENTS + level, final ? 1u : 0u);
}
