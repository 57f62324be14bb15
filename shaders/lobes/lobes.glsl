// lobes.glsl: virtual spherical Gaussian lights: many small lights near one another as one, after
// Tokuyoshi 2015 and 2022. Binding 1.
#ifndef LOBES_GLSL
#define LOBES_GLSL

struct Lobe {
    vec4 centre;    // mean position; w: variance of the position along one axis, m^2
    vec4 axis;      // of the emission, unit; w: its sharpness, 0: the same in every direction
    vec4 intensity; // W/sr towards the axis, red, green, blue
};

layout(set = 0, binding = 1, std430) readonly buffer LobeBuffer
{
    Lobe lobes[];
};

// What arrives at x as a spherical Gaussian: axis, sharpness and amplitude of its radiance. Seen
// from a distance d a cloud of variance s^2 is a lobe of sharpness d^2/s^2, and its radiance
// integrates to intensity/d^2.
struct Incoming {
    vec3 axis;
    float sharpness;
    vec3 amplitude;
};

Incoming lobe_incoming(Lobe lobe, vec3 x)
{
    vec3 to_light = lobe.centre.xyz - x;
    float squared = max(dot(to_light, to_light), 1e-12);
    vec3 axis = to_light * inversesqrt(squared);
    float emitted = exp(lobe.axis.w * (-dot(axis, lobe.axis.xyz) - 1.0));
    return Incoming(axis, squared / lobe.centre.w,
                    lobe.intensity.rgb * (emitted / (6.28318531 * lobe.centre.w)));
}

#endif
