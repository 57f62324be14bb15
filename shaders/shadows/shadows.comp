#version 450
#extension GL_GOOGLE_include_directive : require
// shadows.comp: ground truth of area lights with shadows: every pixel, every light, all 64 rays.
#include "area.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(push_constant) uniform Push
{
    uint root, light_count, first_row;
};
layout(set = 0, binding = 9, rgba32f) writeonly uniform image2D light_image;

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y + first_row);
    Surface s = surface_at(pixel);
    vec3 irradiance = vec3(0.0);
    uint rays = 0u;
    for (uint light = 0u; s.there && light < light_count; light++) {
        float form = area_form_factor(light, s), seen = 0.0, all = 0.0;
        for (uint i = 0u; form > 0.0 && i < AREA_POINTS; i++) {
            float weight = area_weight(light, i, s);
            all += weight;
            if (weight > 0.0) {
                rays++;
                seen += area_sees(light, i, s, root) ? weight : 0.0;
            }
        }
        irradiance += seen > 0.0 ? areas[light].exitance.rgb * (form * seen / all) : vec3(0.0);
    }
    if (s.there)
        imageStore(light_image, pixel, vec4(irradiance, 1.0));
    counter_add_group(COUNT_EVALUATIONS, s.there ? light_count : 0u);
    counter_add_group(COUNT_RAYS, rays);
    counter_add_group(COUNT_SAMPLES, s.there ? 1u : 0u);
}
