#version 450
#extension GL_GOOGLE_include_directive : require
// fit_lobe.comp: the lobes of the new vertices are moved a little, so that they give the irradiance
// that gather_lobe.comp found at the vertex's normal and at four around it (tilted.glsl). A lobe has
// the flux of its share and keeps it; its first moment, hence its axis and sharpness, tells nothing of how
// the share is spread, which matters where the horizon cuts it. Of all changes of the mean
// directions that give the five, the least one is taken, against an error of NOISE of all flux. Where
// the horizon cuts no lobe all fits already and nothing moves.
#define CONTROL_BINDING 1
#define VERTEX_LOBES
#include "../common/frame.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "vertex_kind.glsl"
#include "tilted.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 2) uniform usampler2D normal_image;
layout(set = 0, binding = 3, std430) readonly buffer VertexPixels
{
    uint vertex_pixels[];
};
layout(set = 0, binding = 4, std430) buffer Vertices
{
    Vertex vertices[];
};
layout(set = 0, binding = 5, std430) readonly buffer Tilted
{
    vec4 tilted[]; // irradiance of the mean colour at the normals of tilted.glsl
};

const int NORMALS = 5;
const float NOISE = 0.1;
const float STEP_OF = 0.01; // of the mean direction's length and of a cosine, for differences
const float LONGEST = 0.995; // mean direction

// How a lobe's share of the irradiance grows with its mean direction, at each normal; level: that share.
struct Slopes {
    vec3 of[NORMALS];
    float level[NORMALS];
};

Slopes slopes_at(vec3 direction, vec3 normals[NORMALS])
{
    float r = max(length(direction), 1e-3), dr = r > 0.9 ? -STEP_OF : STEP_OF;
    vec3 axis = direction / r;
    float sharpness = lobe_sharpness(r), other = lobe_sharpness(r + dr);
    Slopes s;
    for (int j = 0; j < NORMALS; j++) {
        float z = clamp(dot(axis, normals[j]), -1.0, 1.0), dz = z > 0.0 ? -STEP_OF : STEP_OF;
        float level = SG_METHOD_L(sharpness, z);
        float along = (SG_METHOD_L(other, z) - level) / dr;
        float across = (SG_METHOD_L(sharpness, z + dz) - level) / (dz * max(r, 0.1));
        s.of[j] = along * axis + across * (normals[j] - z * axis);
        s.level[j] = level;
    }
    return s;
}

// Solves k x = b for a symmetric, positive k; x takes the place of b.
void solve(inout float k[NORMALS][NORMALS], inout float b[NORMALS])
{
    for (int i = 0; i < NORMALS; i++)
        for (int j = i + 1; j < NORMALS; j++) {
            float f = k[j][i] / k[i][i];
            for (int c = i; c < NORMALS; c++)
                k[j][c] -= f * k[i][c];
            b[j] -= f * b[i];
        }
    for (int i = NORMALS - 1; i >= 0; i--) {
        for (int c = i + 1; c < NORMALS; c++)
            b[i] -= k[i][c] * b[c];
        b[i] /= k[i][i];
    }
}

vec3 flux_of(uint slot, uint k)
{
    vec4 both = vertices[slot].rest[k / 2u];
    return vec3(vertices[slot].first[k].w, (k & 1u) == 0u ? both.xy : both.zw);
}

float mean_of(vec3 color)
{
    return (color.r + color.g + color.b) / 3.0;
}

// How much the lobes give too little at the vertex's own normal.
vec3 missing_at(uint slot)
{
    vec4 r = vertices[slot].gradient0, g = vertices[slot].gradient1, b = vertices[slot].gradient2;
    vec3 half_x = vertices[slot].place.xyz;
    return vec3(r.w, g.w, b.w) + vec3(dot(r.xyz, half_x), dot(g.xyz, half_x), dot(b.xyz, half_x));
}

void main()
{
    uint slot = gather_first + gl_GlobalInvocationID.x;
    if (slot >= gather_end)
        return;
    vec3 n = vertex_normal(texelFetch(normal_image, unpack_pixel(vertex_pixels[slot]), 0).xy);
    mat3 tilt = tilt_frame(n);
    vec3 normals[NORMALS] = vec3[](n, tilt[0] + tilt[1], tilt[0] - tilt[1], tilt[0] + tilt[2],
                                   tilt[0] - tilt[2]);

    vec4 wanted = tilted[slot];
    float missing[NORMALS] = float[](mean_of(missing_at(slot)), wanted.x, wanted.y, wanted.z, wanted.w);
    float products[NORMALS][NORMALS], all = 0.0;
    for (int i = 0; i < NORMALS; i++)
        for (int j = 0; j < NORMALS; j++)
            products[i][j] = 0.0;
    for (uint k = 0u; k < uint(LOBES); k++) {
        float f = mean_of(flux_of(slot, k));
        Slopes s = slopes_at(vertices[slot].first[k].xyz / max(f, 1e-20), normals);
        all += f;
        for (int i = 0; i < NORMALS; i++) {
            missing[i] -= i > 0 ? f * s.level[i] : 0.0;
            for (int j = 0; j < NORMALS; j++)
                products[i][j] += f * f * dot(s.of[i], s.of[j]);
        }
    }
    for (int i = 0; i < NORMALS; i++)
        products[i][i] += max(NOISE * NOISE * all * all, 1e-30);
    solve(products, missing);

    vec3 given = vec3(0.0); // more than before at the vertex's own normal
    for (uint k = 0u; k < uint(LOBES); k++) {
        vec3 flux = flux_of(slot, k), first = vertices[slot].first[k].xyz;
        float f = mean_of(flux);
        Slopes s = slopes_at(first / max(f, 1e-20), normals);
        vec3 moved = first;
        for (int i = 0; i < NORMALS; i++)
            moved += f * f * missing[i] * s.of[i];
        moved *= min(LONGEST * f * inversesqrt(max(dot(moved, moved), 1e-30)), 1.0);
        given += lobe_irradiance(moved, flux, n) - flux * s.level[0];
        vertices[slot].first[k].xyz = moved;
    }
    vertices[slot].gradient0.w -= given.r;
    vertices[slot].gradient1.w -= given.g;
    vertices[slot].gradient2.w -= given.b;
}
