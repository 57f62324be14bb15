#version 450
#extension GL_GOOGLE_include_directive : require
// resolve.comp: from irradiance to radiance, and the count of what was lit. A pixel with a surface
// that no pass has written a light value for is uncovered.
#define COUNTERS_BINDING 1
#define COUNTERS_SHARED
#include "../common/frame.glsl"
#include "../common/counters.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(set = 0, binding = 2) uniform sampler2D position_image;
layout(set = 0, binding = 3) uniform sampler2D albedo_image;
layout(set = 0, binding = 4, rgba32f) uniform image2D light_image;
layout(set = 0, binding = 5, rgba32f) writeonly uniform image2D radiance_image;

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool inside = all(lessThan(gl_GlobalInvocationID.xy, view.size.xy));
    bool surface = inside && texelFetch(position_image, pixel, 0).w > 0.0;
    float state = 0.0; // as in the light buffer's fourth channel
    if (inside) {
        vec4 light = surface ? imageLoad(light_image, pixel) : vec4(0.0);
        state = surface && light.w == 0.0 ? -1.0 : light.w;
        imageStore(light_image, pixel, vec4(light.rgb, state));
        vec3 radiance = surface ? texelFetch(albedo_image, pixel, 0).rgb * light.rgb / PI : vec3(0.0);
        imageStore(radiance_image, pixel, vec4(radiance, surface ? 1.0 : 0.0));
    }
    counter_add_group(COUNT_COVERED, state == 0.0 || state == -1.0 ? 0u : 1u);
    counter_add_group(COUNT_UNCOVERED, state == -1.0 ? 1u : 0u);
    counter_add_group(COUNT_WRONG, state == -2.0 ? 1u : 0u);
}
