// full.glsl: irradiance by all 64 rays to lights, one place an invocation: neighbours follow much
// the same way through the tree.
#ifndef FULL_GLSL
#define FULL_GLSL

#include "area.glsl"

// The lights from first up to but without last.
vec3 full_irradiance(Surface s, uint first, uint last, inout uint rays)
{
    vec3 irradiance = vec3(0.0);
    uint light = first;
    uvec2 bits;
    for (; light < last; light++)
        irradiance += area_irradiance(light, 0u, AREA_POINTS, s, bits, rays);
    trace_gave_up = trace_gave_up || light < last;
    return irradiance;
}

#endif
