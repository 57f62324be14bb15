// gather.glsl: light gathering, as the paper's vertex stage does it: all lights into one spherical
// Gaussian a colour channel.
#ifndef GATHER_GLSL
#define GATHER_GLSL

#include "../common/lights.glsl"
#include "../sg.glsl"

struct Lobes {
    vec3 axis[3];   // red, green, blue; 0 where no light arrives, so that it weighs nothing in an
                    // interpolation; else of length 1
    vec3 sharpness;
    vec3 amplitude; // the paper's mu
};

// Sharpness where all light comes from one direction but for rounding.
const float longest_mean = 1.0 - 1.0 / 1048576.0;

// The paper's "projected area on the unit sphere": the solid angle of a light's triangle, by the
// formula of van Oosterom and Strackee. The triple product of the directions is known: it is twice
// the light's area times the distance from its plane, over the three lengths.
float solid_angle(Light l, float in_front, vec3 u, vec3 v, vec3 w, float inverse_lengths)
{
    float numerator = 2.0 * l.plane.w * in_front * inverse_lengths;
    float denominator = 1.0 + dot(u, v) + dot(v, w) + dot(w, u);
    return 2.0 * atan(numerator, denominator);
}

Lobes gather(vec3 x, uint light_count)
{
    vec3 flux = vec3(0.0), red = vec3(0.0), green = vec3(0.0), blue = vec3(0.0);
    for (uint i = 0u; i < light_count; i++) {
        Light l = lights[i];
        vec3 u = l.a.xyz - x, v = l.b.xyz - x, w = l.c.xyz - x;
        float in_front = -dot(u, l.plane.xyz);
        if (in_front < light_closest)
            continue;
        vec3 inverse = inversesqrt(vec3(dot(u, u), dot(v, v), dot(w, w)));
        u *= inverse.x;
        v *= inverse.y;
        w *= inverse.z;
        // radiance times solid angle: a diffuse emitter's radiance is its exitance over pi
        vec3 mu = light_exitance(l) / PI
            * solid_angle(l, in_front, u, v, w, inverse.x * inverse.y * inverse.z);
        // each corner is a ray with a third of it
        vec3 direction = (u + v + w) / 3.0;
        flux += mu;
        red += mu.r * direction;
        green += mu.g * direction;
        blue += mu.b * direction;
    }
    // Toksvig, eqs 4 and 5
    vec3 sizes = vec3(length(red), length(green), length(blue));
    vec3 mean = min(sizes / max(flux, 1e-30), longest_mean);
    Lobes lobes;
    lobes.axis[0] = red / max(sizes.r, 1e-30);
    lobes.axis[1] = green / max(sizes.g, 1e-30);
    lobes.axis[2] = blue / max(sizes.b, 1e-30);
    lobes.sharpness = mean / (1.0 - mean);
    lobes.amplitude = flux / vec3(sg_integral(lobes.sharpness.r), sg_integral(lobes.sharpness.g),
                                  sg_integral(lobes.sharpness.b));
    return lobes;
}

#endif
