// area.glsl: area lights with shadows. Their irradiance is their form factor without shadows times
// the share of it that is visible: of a fixed stratified set of 64 points on the light, each with
// the weight that its piece of the light has at the pixel. The first 16 of the 64 are stratified
// as well. Bound by lib/render/shadows.c.
#ifndef AREA_GLSL
#define AREA_GLSL

#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define TRACE_NODES_BINDING 5
#define TRACE_TRIANGLES_BINDING 6
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "../common/form_factor.glsl"
#include "../trace/trace.glsl"

struct Area {
    vec4 plane;    // unit normal towards the side that emits; w: area
    vec4 exitance; // w: 0
    vec4 middle;   // centroid; w: 0
    uvec4 range;   // first of its triangles among the lights, how many; 0, 0
};
layout(set = 0, binding = 3, std430) readonly buffer Areas
{
    uint root; // for trace_scene
    uint light_count;
    uint unused[2];
    Area areas[];
};
layout(set = 0, binding = 4, std430) readonly buffer Points
{
    vec4 area_points[]; // 64 a light, a little in front of it
};
layout(set = 0, binding = 7) uniform sampler2D position_image;
layout(set = 0, binding = 8) uniform usampler2D normal_image;

const uint AREA_POINTS = 64u;
const uint AREA_FEW = 16u;

struct Surface {
    vec3 position, normal;
    vec3 face;   // geometric normal
    vec3 origin; // where shadow rays begin
    bool there;
};

// Rays begin above the surface: by 1e-4 of its largest coordinate or its distance from the eye,
// whichever is more: some ten times what the position image is off by.
Surface surface_at(ivec2 pixel)
{
    Surface s;
    bool inside = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(uvec2(pixel), view.size.xy));
    vec4 position = inside ? texelFetch(position_image, pixel, 0) : vec4(0.0);
    uvec2 normals = inside ? texelFetch(normal_image, pixel, 0).xy : uvec2(0u);
    s.position = position.xyz;
    s.normal = unpack_normal(normals.x);
    s.face = unpack_normal(normals.y);
    vec3 size = abs(position.xyz);
    s.origin = s.position + 1e-4 * max(max(size.x, size.y), max(size.z, position.w)) * s.face;
    s.there = position.w > 0.0;
    return s;
}

// Without shadows: 0 to 1.
float area_form_factor(uint light, Surface s)
{
    uvec4 range = areas[light].range;
    float sum = 0.0;
    for (uint i = range.x; i < range.x + range.y; i++)
        sum += form_factor(lights[i], s.position, s.normal);
    return sum;
}

// What a point of a light contributes relative to the light's other points.
float area_weight(uint light, uint point, Surface s)
{
    vec3 d = area_points[AREA_POINTS * light + point].xyz - s.position;
    float weight = max(dot(d, s.normal), 0.0) * max(-dot(d, areas[light].plane.xyz), 0.0);
    float d2 = dot(d, d);
    return dot(d, s.face) > 0.0 ? weight / (d2 * d2) : 0.0;
}

// Of a ray's length, that is not looked at: where two surfaces meet, a pixel of one may lie behind the other by
// the rounding of its position, and would be dark for every light.
const float AREA_SKIPPED = 1e-4;

// Nothing between where rays of a surface begin and a point of a light; one ray, where it is wanted.
// All invocations of a subgroup call it together.
bool area_sees_from(uint light, uint point, vec3 origin, bool wanted)
{
    vec3 d = area_points[AREA_POINTS * light + point].xyz - origin;
    Ray ray = trace_ray(origin + AREA_SKIPPED * d, (1.0 - AREA_SKIPPED) * d, wanted ? 1.0 : -1.0);
    return trace_scene(ray, root, true) == TRACE_NONE && wanted;
}

bool area_sees(uint light, uint point, Surface s, bool wanted)
{
    return area_sees_from(light, point, s.origin, wanted);
}

// Irradiance of a light by so many of its points from the first on, one ray to each that gives some;
// bits: which are visible. All invocations of a subgroup call it together.
vec3 area_irradiance(uint light, uint first, uint count, Surface s, out uvec2 bits, inout uint rays)
{
    float form = s.there ? area_form_factor(light, s) : 0.0, seen = 0.0, all = 0.0;
    uint i = 0u, last = trace_any(form > 0.0) ? count : 0u;
    bits = uvec2(0u);
    for (; i < last; i++) {
        float weight = form > 0.0 ? area_weight(light, first + i, s) : 0.0;
        all += weight;
        rays += weight > 0.0 ? 1u : 0u;
        if (area_sees(light, first + i, s, weight > 0.0)) {
            seen += weight;
            bits |= uvec2(i < 32u ? 1u << i : 0u, i < 32u ? 0u : 1u << (i - 32u));
        }
    }
    trace_gave_up = trace_gave_up || i < last;
    return seen > 0.0 ? areas[light].exitance.rgb * (form * seen / all) : vec3(0.0);
}

// At the end of every pass that traces.
void count_rays(uint rays)
{
    counter_add_group(COUNT_RAYS, rays);
    if (trace_gave_up)
        counter_add(COUNT_GAVE_UP, 1u);
}

#endif
