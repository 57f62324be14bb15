// full.glsl: irradiance by all 64 rays to lights, one place an invocation: neighbours follow much
// the same way through the tree.
#ifndef FULL_GLSL
#define FULL_GLSL

#include "area.glsl"

vec3 full_light(uint light, Surface s, inout uint rays)
{
    float form = s.there ? area_form_factor(light, s) : 0.0, seen = 0.0, all = 0.0;
    uint i = 0u, last = trace_any(form > 0.0) ? AREA_POINTS : 0u;
    for (; i < last; i++) {
        float weight = form > 0.0 ? area_weight(light, i, s) : 0.0;
        all += weight;
        rays += weight > 0.0 ? 1u : 0u;
        seen += area_sees(light, i, s, weight > 0.0) ? weight : 0.0;
    }
    trace_gave_up = trace_gave_up || i < last;
    return seen > 0.0 ? areas[light].exitance.rgb * (form * seen / all) : vec3(0.0);
}

// The lights from first up to but without last.
vec3 full_irradiance(Surface s, uint first, uint last, inout uint rays)
{
    vec3 irradiance = vec3(0.0);
    uint light = first;
    for (; light < last; light++)
        irradiance += full_light(light, s, rays);
    trace_gave_up = trace_gave_up || light < last;
    return irradiance;
}

#endif
