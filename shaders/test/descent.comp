#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// descent.comp: for tests: which nodes a descent takes at a point, and the far light that they give.
#include "../common/frame.glsl"
#include "../hull/hull.glsl"
#include "../hull/descent.glsl"
#include "../common/form_factor.glsl"

layout(local_size_x = 64) in;

struct Point {
    vec4 place;  // w: view depth
    vec4 normal; // w: mean irradiance
};
layout(set = 0, binding = 2, std430) readonly buffer Points
{
    Point points[];
};
layout(set = 0, binding = 3, std430) writeonly buffer Taken
{
    uint taken[]; // of a point as many as there are nodes, and 1: how many, then which
};
layout(set = 0, binding = 4, std430) writeonly buffer Sums
{
    vec4 sums[]; // far irradiance; w: nodes tested and not taken
};

void main()
{
    uint i = gl_GlobalInvocationID.x, tested = 0u, listed = 0u;
    if (i >= uint(points.length()))
        return;
    Point p = points[i];
    vec3 sum = vec3(0.0);
    Seeker seekers[1] = {Seeker(p.place.xyz, p.place.w, 0u)};
    for (uint at = 0u; at < nodes_end;) {
        find_lights(at, seekers, p.normal.w, tested);
        for (uint j = 0u; j < found_far_count + found_near_count; j++) {
            uint which = found_at(j);
            Light l = node_light(which);
            vec3 gradient;
            float far = far_share(l, is_leaf(which), p.place.xyz, p.place.w, p.normal.w, gradient);
            sum += far * form_factor(l, p.place.xyz, p.normal.xyz) * light_exitance(l);
            taken[i * (nodes_end + 1u) + ++listed] = which;
        }
    }
    taken[i * (nodes_end + 1u)] = listed;
    sums[i] = vec4(sum, float(tested));
}
