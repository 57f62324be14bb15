// vertex_lobe.glsl: as vertex.glsl, with spherical Gaussians in the place of the moments: what arrives
// at a vertex is divided by direction among LOBES of them, smoothly, and each has the zeroth and the
// first moment of its share. This is where the fitted integral works: a pixel integrates the
// interpolated lobes against its cosine.
#ifndef VERTEX_LOBE_GLSL
#define VERTEX_LOBE_GLSL

#include "../common/method.glsl"

const int LOBES = 5;
const int VERTEX_VECTORS = 2 * LOBES + 3;
// Where each takes most: light reflected from below, which most is where a lamp hangs above,
// is shared by four of them, and the fifth has the rest.
const vec3 LOBE_CENTRES[LOBES] = vec3[](vec3(0.0, 1.0, 0.0), vec3(0.8660254, -0.5, 0.0),
                                        vec3(-0.8660254, -0.5, 0.0), vec3(0.0, -0.5, 0.8660254),
                                        vec3(0.0, -0.5, -0.8660254));
const float LOBE_SHARE = 20.0; // powers of 2 by which a share falls with the cosine to the centre

struct Vertex {
    vec4 first[LOBES]; // first moment of the mean of the colours; w: 0
    vec4 flux[LOBES];  // zeroth moment of each colour; w of the first three: x_v/2
    vec4 gradient0;    // red; c red
    vec4 gradient1;    // green; c green
    vec4 gradient2;    // blue; c blue
};

// Sharpness of the lobe whose mean direction has this length (Banerjee et al. 2005).
float lobe_sharpness(float r)
{
    r = min(r, 0.9999);
    return max(r * (3.0 - r * r) / (1.0 - r * r), 1e-3);
}

// Lobe k: its sharpness and its cosine to n.
vec2 lobe_arguments(Vertex v, int k, vec3 n)
{
    vec3 first = v.first[k].xyz;
    float size2 = dot(first, first), inv = inversesqrt(max(size2, 1e-30));
    float zeroth = dot(v.flux[k].rgb, vec3(1.0 / 3.0));
    return vec2(lobe_sharpness(size2 * inv / max(zeroth, 1e-20)),
                clamp(dot(first, n) * inv, -1.0, 1.0));
}

vec3 vertex_irradiance(Vertex v, vec3 x, vec3 n)
{
    vec3 sum = vec3(v.gradient0.w, v.gradient1.w, v.gradient2.w);
    for (int k = 0; k < LOBES; k++) {
        // a lobe's integral against the cosine: its flux times A_h over the integral of the lobe alone
        vec2 a = lobe_arguments(v, k, n);
        float amplitude = a.x / (2.0 * PI * (1.0 - exp(-2.0 * a.x)));
        sum += v.flux[k].rgb * (amplitude * SG_METHOD_A_h(a.x, a.y));
    }
    vec3 d = x - vec3(v.flux[0].w, v.flux[1].w, v.flux[2].w);
    return sum + vec3(dot(v.gradient0.xyz, d), dot(v.gradient1.xyz, d), dot(v.gradient2.xyz, d));
}

Vertex vertex_zero()
{
    Vertex v;
    for (int k = 0; k < LOBES; k++)
        v.first[k] = v.flux[k] = vec4(0.0);
    v.gradient0 = v.gradient1 = v.gradient2 = vec4(0.0);
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
        v.first[k].xyz += share * mean_e * m.first;
        v.flux[k].rgb += share * m.solid_angle * e;
    }
}

void vertex_finish(inout Vertex v, vec3 x)
{
    v.flux[0].w = 0.5 * x.x;
    v.flux[1].w = 0.5 * x.y;
    v.flux[2].w = 0.5 * x.z;
}

void vertex_local(inout Vertex v, vec3 c)
{
    v.gradient0.w = c.r;
    v.gradient1.w = c.g;
    v.gradient2.w = c.b;
}

void vertex_add(inout Vertex v, float weight, Vertex w)
{
    for (int k = 0; k < LOBES; k++) {
        v.first[k] += weight * w.first[k];
        v.flux[k] += weight * w.flux[k];
    }
    v.gradient0 += weight * w.gradient0;
    v.gradient1 += weight * w.gradient1;
    v.gradient2 += weight * w.gradient2;
}

#endif
