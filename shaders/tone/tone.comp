#version 450
#extension GL_GOOGLE_include_directive : require
// tone.comp: luminance of a coarse grid of pixels, lit exactly: from it the exposure of pictures.
#include "../common/frame.glsl"
#include "../common/form_factor.glsl"

layout(local_size_x = 64) in; // a row of the grid is a work group

layout(set = 0, binding = 2) uniform sampler2D position_image;
layout(set = 0, binding = 3) uniform usampler2D normal_image;
layout(set = 0, binding = 4) uniform sampler2D albedo_image;
layout(set = 0, binding = 5, std430) writeonly buffer Luminances
{
    float luminances[]; // -1 where there is no surface
};

void main()
{
    uvec2 grid = uvec2(64u, gl_NumWorkGroups.x);
    uvec2 cell = uvec2(gl_LocalInvocationID.x, gl_WorkGroupID.x);
    ivec2 pixel = ivec2((2u * cell + 1u) * view.size.xy / (2u * grid));
    vec4 position = texelFetch(position_image, pixel, 0);
    float luminance = -1.0;
    if (position.w > 0.0) {
        vec3 n = unpack_normal(texelFetch(normal_image, pixel, 0).x);
        vec3 irradiance = vec3(0.0);
        for (uint i = 0u; i < view.size.z; i++)
            irradiance += light_exitance(lights[i]) * form_factor(lights[i], position.xyz, n);
        vec3 albedo = texelFetch(albedo_image, pixel, 0).rgb;
        luminance = dot(irradiance * albedo / PI, vec3(0.2126, 0.7152, 0.0722));
    }
    luminances[64u * cell.y + cell.x] = luminance;
}
