// vertex_lobe.glsl: as vertex.glsl, with spherical Gaussians in the place of the moments: what arrives
// at a vertex is divided by direction among LOBES of them, smoothly, and each has the zeroth and the
// first moment of its share; fit_lobe.comp moves the first moments a little. This is where the
// fitted integral works: a pixel integrates the interpolated lobes against its cosine.
#ifndef VERTEX_LOBE_GLSL
#define VERTEX_LOBE_GLSL

#include "../common/method.glsl"

const int LOBES = 6; // an even number; HULL_LOBE_COUNT in lib/render/hull.h
const int VERTEX_VECTORS = 3 * LOBES / 2 + 4;
// Where each takes most: light reflected from below, which most is where a lamp hangs above,
// is shared by five of them, and the sixth has the rest: the corners of a pyramid over a pentagon.
const vec3 LOBE_CENTRES[LOBES] = vec3[](vec3(0.0, 1.0, 0.0), vec3(0.8930286, -0.45, 0.0),
                                        vec3(0.2759610, -0.45, 0.8493206),
                                        vec3(-0.7224753, -0.45, 0.5249090),
                                        vec3(-0.7224753, -0.45, -0.5249090),
                                        vec3(0.2759610, -0.45, -0.8493206));
const float LOBE_SHARE = 20.0; // powers of 2 by which a share falls with the cosine to the centre

struct Vertex {
    vec4 first[LOBES];    // first moment of the mean of the colours; w: zeroth moment of red
    vec4 rest[LOBES / 2]; // zeroth moments of green and blue, of two lobes
    vec4 place;           // x_v/2; w: 0
    vec4 gradient0;       // red; c red
    vec4 gradient1;       // green; c green
    vec4 gradient2;       // blue; c blue
};

// Sharpness of the lobe whose mean direction has this length (Banerjee et al. 2005).
float lobe_sharpness(float r)
{
    r = min(r, 0.9999);
    return max(r * (3.0 - r * r) / (1.0 - r * r), 1e-3);
}

// Zeroth moment of lobe k.
vec3 lobe_flux(Vertex v, int k)
{
    vec4 both = v.rest[k / 2];
    return vec3(v.first[k].w, (k & 1) == 0 ? both.xy : both.zw);
}

// A lobe of this first and zeroth moment: its sharpness and its cosine to n.
vec2 lobe_arguments(vec3 first, vec3 flux, vec3 n)
{
    float size2 = dot(first, first), inv = inversesqrt(max(size2, 1e-30));
    float zeroth = dot(flux, vec3(1.0 / 3.0));
    return vec2(lobe_sharpness(size2 * inv / max(zeroth, 1e-20)),
                clamp(dot(first, n) * inv, -1.0, 1.0));
}

// Its irradiance on a surface with normal n: the flux times A_h over the integral of the lobe alone.
vec3 lobe_irradiance(vec3 first, vec3 flux, vec3 n)
{
    vec2 a = lobe_arguments(first, flux, n);
    return flux * SG_METHOD_L(a.x, a.y);
}

vec3 vertex_irradiance(Vertex v, vec3 x, vec3 n)
{
    vec3 sum = vec3(v.gradient0.w, v.gradient1.w, v.gradient2.w);
    for (int k = 0; k < LOBES; k++)
        sum += lobe_irradiance(v.first[k].xyz, lobe_flux(v, k), n);
    vec3 d = x - v.place.xyz;
    return sum + vec3(dot(v.gradient0.xyz, d), dot(v.gradient1.xyz, d), dot(v.gradient2.xyz, d));
}

Vertex vertex_zero()
{
    Vertex v;
    for (int k = 0; k < LOBES; k++)
        v.first[k] = v.rest[k / 2] = vec4(0.0);
    v.place = v.gradient0 = v.gradient1 = v.gradient2 = vec4(0.0);
    return v;
}

// Takes in the share far of a light of exitance e.
void vertex_take(inout Vertex v, vec3 e, float far, Moments m)
{
    vec3 w = m.first * inversesqrt(max(dot(m.first, m.first), 1e-30));
    float shares[LOBES], sum = 0.0;
    for (int k = 0; k < LOBES; k++) {
        shares[k] = exp2(LOBE_SHARE * dot(w, LOBE_CENTRES[k]));
        sum += shares[k];
    }
    float mean_e = (e.r + e.g + e.b) / 3.0;
    for (int k = 0; k < LOBES; k++) {
        float share = shares[k] * (far / PI / sum);
        vec3 flux = share * m.solid_angle * e;
        v.first[k] += vec4(share * mean_e * m.first, flux.r);
        v.rest[k / 2] += (k & 1) == 0 ? vec4(flux.gb, 0.0, 0.0) : vec4(0.0, 0.0, flux.gb);
    }
}

void vertex_finish(inout Vertex v, vec3 x)
{
    v.place.xyz = 0.5 * x;
}

void vertex_local(inout Vertex v, vec3 c)
{
    v.gradient0.w = c.r;
    v.gradient1.w = c.g;
    v.gradient2.w = c.b;
}

void vertex_add(inout Vertex v, float weight, Vertex w)
{
    for (int k = 0; k < LOBES; k++)
        v.first[k] += weight * w.first[k];
    for (int k = 0; k < LOBES / 2; k++)
        v.rest[k] += weight * w.rest[k];
    v.place += weight * w.place;
    v.gradient0 += weight * w.gradient0;
    v.gradient1 += weight * w.gradient1;
    v.gradient2 += weight * w.gradient2;
}

#endif
