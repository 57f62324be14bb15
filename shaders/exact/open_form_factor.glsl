// open_form_factor.glsl: the form factor of a triangle without a clip: what lies below the horizon
// counts negative. Where nothing does it is the form factor.
#ifndef OPEN_FORM_FACTOR_GLSL
#define OPEN_FORM_FACTOR_GLSL

#include "../common/form_factor.glsl"

// Angle between two unit vectors over its sine; d: their dot product.
float open_angle(float d)
{
    float near = angle_over_sine(min(abs(d), 1.0));
    return d < 0.0 ? 3.14159265 * inversesqrt(max(1.0 - d * d, 1e-12)) - near : near;
}

float open_form_factor(Light l, vec3 x, vec3 n)
{
    vec3 v0 = l.c.xyz - x, v1 = l.b.xyz - x, v2 = l.a.xyz - x; // counter-clockwise about n
    float in_front = -dot(v2, l.plane.xyz);
    v0 *= inversesqrt(dot(v0, v0));
    v1 *= inversesqrt(dot(v1, v1));
    v2 *= inversesqrt(dot(v2, v2));
    float sum = dot(cross(v0, v1), n) * open_angle(dot(v0, v1))
        + dot(cross(v1, v2), n) * open_angle(dot(v1, v2))
        + dot(cross(v2, v0), n) * open_angle(dot(v2, v0));
    return in_front < light_closest ? 0.0 : max(sum, 0.0) * 0.159154943;
}

#endif
