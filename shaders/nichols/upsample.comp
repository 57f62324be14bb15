#version 450
#extension GL_GOOGLE_include_directive : require
// upsample.comp: multi-pass upsampling, from the coarsest level on: what is inside a final fragment
// of a coarser level takes the bilinear mean of that level's values about it, as far as they are
// there and of the same surface; what they were interpolated to on the level below is used by the
// next.
#include "../multires/fragments.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(set = 0, binding = 13, rgba32f) writeonly uniform image2D light_image;

vec3 interpolate(ivec2 at, vec4 own)
{
    ivec2 parent = at / 2, size = ivec2(tiles << (TOP - level - 1u));
    Surface s = surface_at(fragment_pixel(level, uvec2(at)));
    vec4 sum = vec4(own.rgb, 1.0) * 9.0;
    for (int i = 1; i < 4; i++) {
        ivec2 other = parent + ivec2(i & 1, i >> 1) * (2 * (at & 1) - 1);
        if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, size)))
            continue;
        vec4 value = illumination[fragment_index(level + 1u, uvec2(other))];
        Surface there = surface_at(fragment_pixel(level + 1u, uvec2(other)));
        float off = abs(dot(there.position - s.position, s.face));
        off /= view.eye.w * distance(s.position, view.eye.xyz);
        if (value.w != NOTHING && there.there && off < 4.0 * plane_limit
            && distance(s.normal, there.normal) < 2.0 * normal_limit)
            sum += vec4(value.rgb, 1.0) * (i == 3 ? 1.0 : 3.0);
    }
    return sum.rgb / sum.w;
}

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = ivec2(tiles << (TOP - level));
    if (any(greaterThanEqual(at, size)))
        return;
    uint index = fragment_index(level, uvec2(at));
    vec4 value = illumination[index];
    if (value.w == NOTHING && level < TOP) {
        vec4 parent = illumination[fragment_index(level + 1u, uvec2(at / 2))];
        if (parent.w != NOTHING) {
            value = vec4(interpolate(at, parent), PART);
            illumination[index] = value;
        }
    }
    if (level == 0u && value.w != NOTHING && surface_at(at).there)
        imageStore(light_image, at, vec4(value.rgb, 1.0));
}
