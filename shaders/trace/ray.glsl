// ray.glsl: a ray against a box and against a triangle.
//
// Watertight: a ray through an edge that two triangles share hits one of them. The corners are
// sheared to where the ray is the z axis (Woop, Benthin and Wald 2013), and what decides about
// an edge is the same rounded number, but for its sign, for both triangles. Boxes are a little
// wider than their rounding.
#ifndef RAY_GLSL
#define RAY_GLSL

struct Ray {
    vec3 origin, inverse; // inverse of the direction, finite
    vec3 shear;           // of x and y along z; z: 1 over the largest component of the direction
    int axis;             // of that component
    float far;            // hits at or beyond it do not count; less than 0: no ray
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

// Where the ray enters a box; far beyond everything where it does not. Distances are compared as
// integers, which is cheaper and the same but among those below 0: there the box is missed, as what
// leaves it is below 0 and what enters is not.
float trace_box(Ray ray, vec3 low, vec3 high)
{
    ivec3 a = floatBitsToInt((low - ray.origin) * ray.inverse);
    ivec3 b = floatBitsToInt((high - ray.origin) * ray.inverse);
    ivec3 near = min(a, b), far = max(a, b);
    float enter = intBitsToFloat(max(max(near.x, near.y), max(near.z, 0)));
    float leave = intBitsToFloat(min(min(far.x, far.y), min(far.z, floatBitsToInt(ray.far))));
    return enter <= leave * 1.0000005 ? enter : 3e38; // four roundings
}

// Hits the triangle: shortens ray.far and is true.
bool trace_triangle(inout Ray ray, vec3 p, vec3 q, vec3 r)
{
    precise vec3 a = trace_turn(p - ray.origin, ray.axis);
    precise vec3 b = trace_turn(q - ray.origin, ray.axis);
    precise vec3 c = trace_turn(r - ray.origin, ray.axis);
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

#endif
