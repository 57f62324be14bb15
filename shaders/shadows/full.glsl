// full.glsl: one place by all 64 rays to every light: a ray each for the 64 invocations of a work
// group.
#ifndef FULL_GLSL
#define FULL_GLSL

#include "area.glsl"

shared uint full_bits[2]; // of the points that are visible
shared float full_seen[64], full_all[64], full_form[8];

// In uniform control flow; irradiance in the first invocation, 0 in the others.
vec3 full_light(uint light, Surface s, inout uint rays)
{
    uint mine = gl_LocalInvocationIndex;
    uvec4 range = areas[light].range;
    if (mine < 2u)
        full_bits[mine] = 0u;
    if (mine < range.y) // 6 triangles at most
        full_form[mine] = s.there ? form_factor(lights[range.x + mine], s.position, s.normal) : 0.0;
    barrier();
    float form = 0.0, seen = 0.0, all = 0.0;
    for (uint i = 0u; i < range.y; i++)
        form += full_form[i];
    float weight = form > 0.0 ? area_weight(light, mine, s) : 0.0;
    bool sees = false;
    if (weight > 0.0) {
        rays++;
        sees = area_sees(light, mine, s);
    }
    full_seen[mine] = sees ? weight : 0.0;
    full_all[mine] = weight;
    if (sees)
        atomicOr(full_bits[mine >> 5], 1u << (mine & 31u));
    barrier();
    for (uint i = 0u; mine == 0u && i < 64u; i++) {
        seen += full_seen[i];
        all += full_all[i];
    }
    barrier();
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
