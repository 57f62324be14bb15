// form_factor.glsl: how much of a surface's cosine-weighted hemisphere a triangle of light fills.
//
//     irradiance += light_exitance(l) * form_factor(l, x, n);
//
// Lambert's sum over the edges of the triangle clipped to the horizon of n: each edge gives its
// angle seen from x times the cosine between n and the normal of the plane through x and the edge.
// The clipped polygon itself is never made: a cut edge is a shorter piece of the same great circle.
// Straight-line code without a branch or an acos. Absolute error below 1e-6 where the farthest
// corner is less than 30 times as far as the light's plane, below 1e-5 up to 250 times.
#ifndef FORM_FACTOR_GLSL
#define FORM_FACTOR_GLSL

#include "lights.glsl"

// acos(x)/sqrt(1 - x^2) on [0, 1]: Chebyshev expansion, error 2.2e-7 in float.
float angle_over_sine(float x)
{
    float y = 0.01765366829931736;
    y = y * x - 0.0979687049984932;
    y = y * x + 0.2532384693622589;
    y = y * x - 0.4245661795139313;
    y = y * x + 0.5570220351219177;
    y = y * x - 0.6610894799232483;
    y = y * x + 0.7848962545394897;
    y = y * x - 0.9999822378158569;
    return y * x + 1.570796251296997;
}

// Angle (0 to pi) of an edge's part above the horizon, times the cosine between n and the edge's
// plane. g: cross product of its ends on the unit sphere, d: their dot product, z0 and z1: their
// heights, inv: 1 over the length of z0 v1 - z1 v0, which points to where it meets the horizon.
float edge_sum(vec3 g, vec3 n, float d, float z0, float z1, float inv)
{
    float along = dot(g, n);
    float high = max(z0, z1), low = min(z0, z1);
    bool cut = low < 0.0;
    float x = cut ? (high * d - low) * inv : d;
    float part = cut ? high * inv : 1.0;
    float near = angle_over_sine(min(abs(x), 1.0)) * clamp(along * part, -1.0, 1.0);
    float wide = 3.14159265 * along * inversesqrt(max(dot(g, g), 1e-30)) - near;
    return high <= 0.0 ? 0.0 : x < 0.0 ? wide : near;
}

float form_factor(Light l, vec3 x, vec3 n)
{
    vec3 v0 = l.c.xyz - x, v1 = l.b.xyz - x, v2 = l.a.xyz - x; // counter-clockwise about n
    float in_front = -dot(v2, l.plane.xyz);
    v0 *= inversesqrt(dot(v0, v0));
    v1 *= inversesqrt(dot(v1, v1));
    v2 *= inversesqrt(dot(v2, v2));
    float z0 = dot(v0, n), z1 = dot(v1, n), z2 = dot(v2, n);

    // Where the edges meet the horizon. As vectors: the same from dot products alone loses half of
    // the digits beside a long edge.
    vec3 p0 = z0 * v1 - z1 * v0, p1 = z1 * v2 - z2 * v1, p2 = z2 * v0 - z0 * v2;
    float inv0 = inversesqrt(max(dot(p0, p0), 1e-30));
    float inv1 = inversesqrt(max(dot(p1, p1), 1e-30));
    float inv2 = inversesqrt(max(dot(p2, p2), 1e-30));
    float sum = edge_sum(cross(v0, v1), n, dot(v0, v1), z0, z1, inv0) +
                edge_sum(cross(v1, v2), n, dot(v1, v2), z1, z2, inv1) +
                edge_sum(cross(v2, v0), n, dot(v2, v0), z2, z0, inv2);

    // The piece of the horizon between the two cuts, if there are any; p and q have opposite signs.
    bool cut0 = (z0 > 0.0) != (z1 > 0.0), cut1 = (z1 > 0.0) != (z2 > 0.0);
    vec3 p = cut0 ? p0 * inv0 : p1 * inv1;
    vec3 q = cut0 && cut1 ? p1 * inv1 : p2 * inv2;
    float c = -dot(p, q);
    float near = angle_over_sine(min(abs(c), 1.0)) * min(abs(dot(cross(p, q), n)), 1.0);
    sum += !(cut0 || cut1) ? 0.0 : c < 0.0 ? 3.14159265 - near : near;
    return in_front < light_closest ? 0.0 : max(sum, 0.0) * 0.159154943;
}

#endif
