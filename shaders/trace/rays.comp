#version 450
#extension GL_GOOGLE_include_directive : require
// rays.comp: rays from a buffer against the scene: what the tests compare ray by ray.
#define TRACE_NODES_BINDING 0
#define TRACE_TRIANGLES_BINDING 1
#include "trace.glsl"

layout(local_size_x = 64) in;

layout(push_constant) uniform Push
{
    uint root, count, any; // any: not 0: whatever is hit first, else the nearest
};

struct RayData {
    vec4 origin;    // w: far, in lengths of the direction
    vec4 direction; // w: 0
};
layout(set = 0, binding = 2, std430) readonly buffer Rays { RayData rays[]; };
// x: number of the triangle in the scene, or TRACE_NONE; y: bits of how far
layout(set = 0, binding = 3, std430) writeonly buffer Hits { uvec2 hits[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    bool there = i < count;
    uint of = there ? i : 0u;
    Ray ray = trace_ray(rays[of].origin.xyz, rays[of].direction.xyz,
                        there ? rays[of].origin.w : -1.0);
    uint found = trace_scene(ray, root, any != 0u);
    if (found != TRACE_NONE)
        found = floatBitsToUint(trace_triangles[12u * found + 3u]);
    if (there)
        hits[i] = uvec2(found, floatBitsToUint(ray.far));
}
