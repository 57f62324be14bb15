// vertex_lobe.glsl: as vertex.glsl, with one spherical Gaussian a colour in the place of the moments up
// to order 2: the one that has the same zeroth and first moment. This is where the fitted integral
// works: a pixel integrates the interpolated lobe against its cosine.
#ifndef VERTEX_LOBE_GLSL
#define VERTEX_LOBE_GLSL

#include "../common/method.glsl"

const float NORMAL_FAR = 0.2, NORMAL_NEAR = 0.9;
// sines of elevations between which light begins to count
const float LOWEST = -0.9, HIGHEST = -0.1;
const int VERTEX_VECTORS = 9;

struct Vertex {
    vec4 red, green, blue; // axis, sharpness; while gathering: first moment, zeroth moment
    vec4 flux;             // integral of each lobe; w: 0
    vec4 place;            // x_v/2; c red
    vec4 gradient0;        // red; c green
    vec4 gradient1;        // green; c blue
    vec4 gradient2;        // blue; w: 0
    vec4 normal;           // for which c and G hold; w: 0
};

// The lobe's integral against the cosine: flux times A_h over the integral of the lobe alone.
float lobe_irradiance(vec4 lobe, float flux, vec3 n)
{
    float lambda = max(lobe.w, 1e-3);
    float along = dot(lobe.xyz, n) * inversesqrt(max(dot(lobe.xyz, lobe.xyz), 1e-20));
    float amplitude = flux * lambda / (2.0 * PI * (1.0 - exp(-2.0 * lambda)));
    return amplitude * SG_METHOD_A_h(lambda, clamp(along, -1.0, 1.0));
}

vec3 vertex_irradiance(Vertex v, vec3 x, vec3 n)
{
    vec3 d = x - v.place.xyz;
    vec3 lobes = vec3(lobe_irradiance(v.red, v.flux.r, n), lobe_irradiance(v.green, v.flux.g, n),
                      lobe_irradiance(v.blue, v.flux.b, n));
    vec3 local = vec3(v.place.w, v.gradient0.w, v.gradient1.w)
        + vec3(dot(v.gradient0.xyz, d), dot(v.gradient1.xyz, d), dot(v.gradient2.xyz, d));
    return lobes + smoothstep(NORMAL_FAR, NORMAL_NEAR, dot(n, v.normal.xyz)) * local;
}

Vertex vertex_zero()
{
    const vec4 o = vec4(0.0);
    return Vertex(o, o, o, o, o, o, o, o, o);
}

void vertex_take(inout Vertex v, vec3 e, float far, Moments m)
{
    vec4 both = far / PI * vec4(m.first, m.solid_angle);
    v.red += e.r * both;
    v.green += e.g * both;
    v.blue += e.b * both;
}

// Sharpness of the lobe whose mean direction has this length (Banerjee et al. 2005).
float lobe_sharpness(float r)
{
    r = min(r, 0.9999);
    return r * (3.0 - r * r) / (1.0 - r * r);
}

vec4 lobe_of_moments(vec4 m)
{
    float size = length(m.xyz);
    return vec4(m.xyz / max(size, 1e-20), lobe_sharpness(size / max(m.w, 1e-20)));
}

void vertex_finish(inout Vertex v, vec3 n)
{
    v.normal.xyz = n;
    v.flux.rgb = vec3(v.red.w, v.green.w, v.blue.w);
    v.red = lobe_of_moments(v.red);
    v.green = lobe_of_moments(v.green);
    v.blue = lobe_of_moments(v.blue);
}

void vertex_add(inout Vertex v, float weight, Vertex w)
{
    v.red += weight * w.red;
    v.green += weight * w.green;
    v.blue += weight * w.blue;
    v.flux += weight * w.flux;
    v.place += weight * w.place;
    v.gradient0 += weight * w.gradient0;
    v.gradient1 += weight * w.gradient1;
    v.gradient2 += weight * w.gradient2;
    v.normal += weight * w.normal;
}

#endif
