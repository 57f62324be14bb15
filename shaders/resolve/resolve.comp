#version 450
#extension GL_GOOGLE_include_directive : require
// resolve.comp: from irradiance to radiance.
#include "../common/frame.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D albedo_image;
layout(set = 0, binding = 2) uniform sampler2D light_image;
layout(set = 0, binding = 3, rgba32f) writeonly uniform image2D radiance_image;

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, view.size.xy)))
        return;
    // both are 0 where there is no surface
    vec4 albedo = texelFetch(albedo_image, pixel, 0);
    vec3 irradiance = texelFetch(light_image, pixel, 0).rgb;
    imageStore(radiance_image, pixel, vec4(albedo.rgb * irradiance / PI, albedo.a));
}
