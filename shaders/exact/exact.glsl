// exact.glsl: ground truth. Every pixel, every light: its form factor, clipped to the pixel's
// horizon where the light crosses it by FORM_FACTOR(light, x, n).
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#include "../common/frame.glsl"
#include "../common/counters.glsl"

layout(push_constant) uniform Push
{
    uint first_row; // of this dispatch: large images are done in strips
};

layout(set = 0, binding = 3) uniform sampler2D position_image;
layout(set = 0, binding = 4) uniform usampler2D normal_image;
layout(set = 0, binding = 5, rgba32f) writeonly uniform image2D light_image;

bool read_place(uvec2 place, out vec3 x, out vec3 n)
{
    place.y += first_row;
    bool inside = all(lessThan(place, view.size.xy));
    vec4 position = inside ? texelFetch(position_image, ivec2(place), 0) : vec4(0.0);
    x = position.xyz;
    n = position.w > 0.0 ? unpack_normal(texelFetch(normal_image, ivec2(place), 0).x) : vec3(0.0);
    return position.w > 0.0;
}

void write_place(uvec2 place, bool surface, vec3 irradiance)
{
    place.y += first_row;
    if (surface)
        imageStore(light_image, ivec2(place), vec4(irradiance, 1.0));
}

#include "four.glsl"
