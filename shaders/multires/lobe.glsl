// lobe.glsl: irradiance of lights that are visible as a whole: their form factor; or where
// MULTIRES_LOBES is defined, the lights taken as spherical Gaussians, integrated by the fitted form.
#ifndef LOBE_GLSL
#define LOBE_GLSL

#ifdef MULTIRES_LOBES

#include "../common/method.glsl"

// What area_form_factor gives, nearly. The light is taken as the cone of directions that a disc of
// its area would fill, seen from as far and at the same angle; the lobe has the cone's solid angle
// and the length of its mean direction.
float lobe_form_factor(uint light, Surface s)
{
    vec3 d = areas[light].middle.xyz - s.position;
    float d2 = max(dot(d, d), 1e-12), inverse = inversesqrt(d2);
    float facing = max(-dot(d, areas[light].plane.xyz) * inverse, 0.0);
    float part = 1.0 - inversesqrt(1.0 + areas[light].plane.w * facing / (PI * d2));
    float mean = 1.0 - 0.5 * part; // of the cosine with the axis
    float lambda = mean * (3.0 - mean * mean) / max(1.0 - mean * mean, 1e-4);
    float along = clamp(dot(d, s.normal) * inverse, -1.0, 1.0);
    return 2.0 * part / sg_integral(lambda) * SG_METHOD_A_h(lambda, along);
}

// The lobe's: the form factor is needed only where some of a light is seen, but not all.
float form_before_test(uint light, Surface s)
{
    return max(lobe_form_factor(light, s), 1e-6); // rays are traced from everywhere
}

float form_after_test(uint light, Surface s, float form, float seen, float all)
{
    if (seen <= 0.0)
        return 0.0;
    return seen < all ? area_form_factor(light, s) : lobe_form_factor(light, s);
}

#else

// Rays are traced where it is not 0.
float form_before_test(uint light, Surface s)
{
    return area_form_factor(light, s);
}

// What exitance is to be multiplied with where `seen` of `all` is visible.
float form_after_test(uint light, Surface s, float form, float seen, float all)
{
    return form;
}

#endif
#endif
