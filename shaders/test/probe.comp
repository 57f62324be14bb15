#version 450
#extension GL_GOOGLE_include_directive : require
// probe.comp: for tests: what the hull's passes compute of one light at one point each.
#include "../common/frame.glsl"
#include "../common/form_factor.glsl"
#include "../hull/hull.glsl"
#include "../hull/window.glsl"
#include "../hull/moments.glsl"

layout(local_size_x = 64) in;

struct Point {
    vec4 place;  // w: view depth
    vec4 normal; // w: mean irradiance
};
struct Result {
    vec4 first, squares, products; // moments; w: solid angle, form factor, near weight
    vec4 gradient;                 // of the form factor; w: 0
    vec4 slope;                    // gradient of the near weight; w: 0
};

layout(set = 0, binding = 2, std430) readonly buffer Points
{
    Point points[];
};
layout(set = 0, binding = 3, std430) writeonly buffer Results
{
    Result results[];
};

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(points.length()))
        return;
    Light l = lights[i];
    Point p = points[i];
    Moments m = light_moments(l, p.place.xyz);
    vec3 slope;
    float weight = near_weight(l, p.place.xyz, p.place.w, p.normal.w, slope);
    results[i] = Result(vec4(m.first, m.solid_angle),
                        vec4(m.squares, form_factor(l, p.place.xyz, p.normal.xyz)),
                        vec4(m.products, weight),
                        vec4(far_light(l, p.place.xyz, p.normal.xyz).gradient, 0.0),
                        vec4(slope, 0.0));
}
