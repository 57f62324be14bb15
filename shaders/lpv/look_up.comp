#version 450
#extension GL_GOOGLE_include_directive : require
// look_up.comp: the light that has passed the voxels around a pixel's surface, interpolated, against
// the clamped cosine about its normal: irradiance, added to what the pixel has.
#include "../common/frame.glsl"
#include "volume.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(set = 0, binding = 1, std430) readonly buffer Sums { Passed sums[]; };
layout(set = 0, binding = 2) uniform sampler2D position_image;
layout(set = 0, binding = 3) uniform usampler2D normal_image;
layout(set = 0, binding = 4) uniform sampler2D light_image;
layout(set = 0, binding = 5, rgba32f) writeonly uniform image2D lit_image;

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, view.size.xy)))
        return;
    vec4 position = texelFetch(position_image, pixel, 0);
    uvec2 normals = texelFetch(normal_image, pixel, 0).xy;
    vec3 normal = unpack_normal(normals.x), face = unpack_normal(normals.y);
    vec3 at = clamp((position.xyz - low) / side + lift * face - 0.5, vec3(0.0), vec3(size - 1u));
    uvec3 place = uvec3(at), next = min(place + 1u, size - 1u);
    vec3 part = at - vec3(place);
    vec3 share = normal * normal;
    uvec3 facing = uvec3(0u, 2u, 4u) + uvec3(greaterThan(normal, vec3(0.0)));
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < 8u; i++) {
        bvec3 far = bvec3((i & 1u) != 0u, (i & 2u) != 0u, (i & 4u) != 0u);
        vec3 weights = mix(1.0 - part, part, far);
        uint voxel = voxel_at(mix(place, next, far));
        sum += weights.x * weights.y * weights.z
            * (share.x * sums[voxel].by[facing.x].rgb + share.y * sums[voxel].by[facing.y].rgb
                + share.z * sums[voxel].by[facing.z].rgb);
    }
    vec4 light = texelFetch(light_image, pixel, 0);
    if (light.w != 0.0)
        light.rgb += max(sum, vec3(0.0)) / (side * side);
    imageStore(lit_image, pixel, light);
}
