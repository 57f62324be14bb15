#version 450
#extension GL_GOOGLE_include_directive : require
// gather.comp: what each side of each sample gives back: albedo times the irradiance of some of the
// area lights, by shadow rays to a stratified set of points on them, and of the emitters, which
// stand for the texels of the reflective shadow map.
#include "../shadows/area.glsl"
#include "samples.glsl"

layout(local_size_x = 64) in;

layout(push_constant) uniform Push
{
    uint samples;
    uint points;                  // of each light: 16 or 64
    uint first_light, last_light; // of this dispatch
    uint emitter_count;
    uint add; // not 0: to what earlier dispatches found
};

// A disc that reflects in all directions of one side.
struct Emitter {
    vec4 position; // w: its radius squared
    vec4 normal;
    vec4 flux; // W; w: 0
};
layout(set = 0, binding = 9, std430) readonly buffer Samples { LpvSample points_on_surfaces[]; };
layout(set = 0, binding = 10, std430) buffer Reflected { vec4 reflected[]; }; // W/m^2, two a sample
layout(set = 0, binding = 11, std430) readonly buffer Emitters { Emitter emitters[]; };

// Of a disc as of a point, but no more than the disc gives from close by.
vec3 from_emitter(uint emitter, Surface s, inout uint rays)
{
    Emitter e = emitters[emitter];
    vec3 d = e.position.xyz - s.position;
    float square = dot(d, d), facing = -dot(d, e.normal.xyz), above = dot(d, s.normal);
    bool wanted = s.there && facing > 0.0 && above > 0.0 && dot(d, s.face) > 0.0;
    rays += wanted ? 1u : 0u;
    vec3 end = e.position.xyz + (s.origin - s.position) * 0.5 - s.origin;
    Ray ray = trace_ray(s.origin, end, wanted ? 0.999 : -1.0);
    if (trace_scene(ray, root, true) != TRACE_NONE || !wanted)
        return vec3(0.0);
    return e.flux.rgb * (above * facing / (PI * square * (square + e.position.w)));
}

void main()
{
    uint index = gl_GlobalInvocationID.x, rays = 0u;
    bool inside = index < 2u * samples;
    LpvSample at = points_on_surfaces[inside ? index / 2u : 0u];
    float side = (index & 1u) == 0u ? 1.0 : -1.0;
    Surface s;
    s.position = at.position.xyz;
    s.normal = side * at.normal.xyz;
    s.face = side * at.face.xyz;
    vec3 size = abs(s.position);
    s.origin = s.position + 1e-4 * max(size.x, max(size.y, size.z)) * s.face;
    s.there = inside;
    vec3 irradiance = vec3(0.0);
    uint light = first_light, emitter = 0u;
    uvec2 bits;
    for (; light < last_light; light++)
        irradiance += area_irradiance(light, 0u, points, s, bits, rays);
    for (; emitter < emitter_count; emitter++)
        irradiance += from_emitter(emitter, s, rays);
    trace_gave_up = trace_gave_up || light < last_light || emitter < emitter_count;
    if (inside) {
        vec4 before = add != 0u ? reflected[index] : vec4(0.0);
        reflected[index] = before + vec4(at.albedo.rgb * irradiance, 0.0);
    }
    counter_add_group(COUNT_EVALUATIONS, inside ? last_light - first_light + emitter_count : 0u);
    counter_add_group(COUNT_SAMPLES, inside && side > 0.0 && add == 0u ? 1u : 0u);
    count_rays(rays);
}
