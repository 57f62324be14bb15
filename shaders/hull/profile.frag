#version 450
#extension GL_GOOGLE_include_directive : require
// profile.frag: what hull_lobe.frag asks the fitted form for one lobe: sharpness, cosine, and the
// square of the luminance of the lobe's flux.
#define VERTEX_LOBES
#define HULL_PIXEL(v, x, n) profile_point(v, n)
#include "../common/frame.glsl"
#include "vertex_kind.glsl"

layout(push_constant) uniform Push
{
    int lobe;
};

vec4 profile_point(Vertex v, vec3 n)
{
    vec3 flux = lobe_flux(v, lobe);
    float luminance = dot(flux, vec3(0.2126, 0.7152, 0.0722));
    return vec4(lobe_arguments(v.first[lobe].xyz, flux, n), luminance * luminance, 1.0);
}

#include "hull_frag.glsl"
