// frame.glsl: the camera and what every pass reads of the G-buffer. Binding 0 of every shader.
#ifndef FRAME_GLSL
#define FRAME_GLSL

struct View {
    mat4 clip_from_world;
    mat4 world_from_clip;
    vec4 eye;                // w: height of a pixel at distance 1 along the view axis
    vec4 right, up, forward; // unit; w: 0
    vec4 range;              // near, far, width over height, tan(fov_y/2)
    uvec4 size;              // width, height, lights, triangles
};

layout(set = 0, binding = 0, std430) readonly buffer ViewBuffer
{
    View view;
};

const float PI = 3.14159265358979;

// 1 where x is not negative, else -1: unlike sign(), never 0
vec2 sign_not_zero(vec2 x)
{
    return vec2(x.x >= 0.0 ? 1.0 : -1.0, x.y >= 0.0 ? 1.0 : -1.0);
}

// A unit vector as a point of the octahedron unfolded to a square, 16 bits a side: about 4e-5 off.
uint pack_normal(vec3 n)
{
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    if (n.z < 0.0)
        p = (1.0 - abs(p.yx)) * sign_not_zero(p);
    return packSnorm2x16(p);
}

vec3 unpack_normal(uint packed)
{
    vec2 p = unpackSnorm2x16(packed);
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0)
        n.xy = (1.0 - abs(n.yx)) * sign_not_zero(n.xy);
    return normalize(n);
}

// The direction from the eye through a point of the image, given in pixels (the centre of the first
// one is at 0.5), of length 1 along the view axis: eye + z * view_ray(p) is at view depth z.
vec3 view_ray(vec2 pixel)
{
    vec2 ndc = 2.0 * pixel / vec2(view.size.xy) - 1.0;
    return view.forward.xyz
        + view.range.w * (ndc.x * view.range.z * view.right.xyz - ndc.y * view.up.xyz);
}

#endif
