// full.glsl: irradiance by all 64 rays to every light.
#ifndef FULL_GLSL
#define FULL_GLSL

#include "area.glsl"

vec3 full_irradiance(Surface s, inout uint rays)
{
    vec3 irradiance = vec3(0.0);
    for (uint light = 0u; s.there && light < light_count; light++) {
        float form = area_form_factor(light, s), seen = 0.0, all = 0.0;
        for (uint i = 0u; form > 0.0 && i < AREA_POINTS; i++) {
            float weight = area_weight(light, i, s);
            all += weight;
            if (weight > 0.0) {
                rays++;
                seen += area_sees(light, i, s) ? weight : 0.0;
            }
        }
        irradiance += seen > 0.0 ? areas[light].exitance.rgb * (form * seen / all) : vec3(0.0);
    }
    return irradiance;
}

#endif
