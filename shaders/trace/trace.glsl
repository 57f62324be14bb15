// trace.glsl: rays against the scene's triangles: down a tree of boxes (lib/render/bvh.h) with an
// explicit stack. Before including it:
//     #define TRACE_NODES_BINDING 5, #define TRACE_TRIANGLES_BINDING 6
//
// Watertight: a ray through an edge that two triangles share hits one of them. The corners are
// sheared to where the ray is the z axis (Woop, Benthin and Wald 2013), and what decides about
// an edge is the same rounded number, but for its sign, for both triangles. Boxes are a little
// wider than their rounding.
#ifndef TRACE_GLSL
#define TRACE_GLSL

layout(set = 0, binding = TRACE_NODES_BINDING, std430) readonly buffer TraceNodes
{
    vec4 trace_nodes[]; // four a node
};
layout(set = 0, binding = TRACE_TRIANGLES_BINDING, std430) readonly buffer TraceTriangles
{
    vec4 trace_triangles[]; // three a triangle
};

const uint TRACE_EMPTY = 0x7fffffffu;
const uint TRACE_LEAF = 0x80000000u;
const uint TRACE_NONE = 0xffffffffu;
const uint TRACE_STACK = 64u;

// Drivers may end loops that run long (llvmpipe does after 65,535 turns of all loops of an
// invocation together): true where a ray was not followed to its end.
bool trace_gave_up = false;

struct Ray {
    vec3 origin, inverse; // inverse of the direction, finite
    vec3 shear;           // of x and y along z; z: 1 over the largest component of the direction
    int axis;             // of that component
    float far;            // hits at or beyond it do not count
};

// p with the component of the given number last and the order of rotation kept
vec3 trace_turn(vec3 p, int axis)
{
    return axis == 2 ? p : axis == 1 ? p.zxy : p.yzx;
}

// far in lengths of the direction, which need not be of length 1, but not 0
Ray trace_ray(vec3 origin, vec3 direction, float far)
{
    Ray ray;
    ray.origin = origin;
    vec3 size = abs(direction);
    ray.axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    vec3 d = trace_turn(direction, ray.axis);
    ray.shear = vec3(d.xy, 1.0) / d.z;
    vec3 least = max(size, vec3(1e-20 * max(size.x, max(size.y, size.z))));
    ray.inverse = mix(vec3(1.0), vec3(-1.0), lessThan(direction, vec3(0.0))) / least;
    ray.far = far;
    return ray;
}

// Where the ray enters a box; far beyond everything where it does not.
float trace_box(Ray ray, vec3 low, vec3 high)
{
    vec3 a = (low - ray.origin) * ray.inverse, b = (high - ray.origin) * ray.inverse;
    vec3 near = min(a, b), far = max(a, b);
    float enter = max(max(near.x, near.y), max(near.z, 0.0));
    float leave = min(min(far.x, far.y), far.z) * 1.0000005; // four roundings
    return enter <= min(leave, ray.far) ? enter : 3e38;
}

// Hits triangle number t in the order of the leaves: shortens ray.far and is true.
bool trace_triangle(inout Ray ray, uint t)
{
    precise vec3 a = trace_turn(trace_triangles[3u * t].xyz - ray.origin, ray.axis);
    precise vec3 b = trace_turn(trace_triangles[3u * t + 1u].xyz - ray.origin, ray.axis);
    precise vec3 c = trace_turn(trace_triangles[3u * t + 2u].xyz - ray.origin, ray.axis);
    precise vec2 pa = a.xy - ray.shear.xy * a.z;
    precise vec2 pb = b.xy - ray.shear.xy * b.z;
    precise vec2 pc = c.xy - ray.shear.xy * c.z;
    precise float u = pc.x * pb.y - pc.y * pb.x;
    precise float v = pa.x * pc.y - pa.y * pc.x;
    precise float w = pb.x * pa.y - pb.y * pa.x;
    float least = min(u, min(v, w)), most = max(u, max(v, w)), det = u + v + w;
    float at = ray.shear.z * (u * a.z + v * b.z + w * c.z) / det;
    bool hit = (least >= 0.0 || most <= 0.0) && det != 0.0 && at > 0.0 && at < ray.far;
    ray.far = hit ? at : ray.far;
    return hit;
}

// The number of a triangle hit, in the order of the leaves, ray.far where; TRACE_NONE: none. any:
// the first one found, else the nearest.
uint trace_scene(inout Ray ray, uint root, bool any)
{
    uint stack[TRACE_STACK];
    uint top = 0u, node = root, found = TRACE_NONE;
    while (node != TRACE_EMPTY) {
        if (node >= TRACE_LEAF) {
            uint first = (node & 0x7fffffffu) >> 3, last = first + (node & 7u);
            for (uint t = first; t <= last; t++)
                if (trace_triangle(ray, t))
                    found = t;
            if (any && found != TRACE_NONE)
                break;
            node = top > 0u ? stack[--top] : TRACE_EMPTY;
            continue;
        }
        vec4 p = trace_nodes[4u * node], q = trace_nodes[4u * node + 1u];
        float first = trace_box(ray, p.xyz, q.xyz);
        float second = trace_box(ray, trace_nodes[4u * node + 2u].xyz,
                                 trace_nodes[4u * node + 3u].xyz);
        bool swap = second < first;
        uint here = floatBitsToUint(p.w), there = floatBitsToUint(q.w);
        uint near = swap ? there : here, far = swap ? here : there;
        if (max(first, second) < 3e38)
            stack[top++] = far;
        if (min(first, second) < 3e38)
            node = near;
        else
            node = top > 0u ? stack[--top] : TRACE_EMPTY;
    }
    trace_gave_up = trace_gave_up || (node != TRACE_EMPTY && !(any && found != TRACE_NONE));
    return found;
}

#endif
