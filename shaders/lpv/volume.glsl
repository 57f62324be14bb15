// volume.glsl: a volume of voxels, each with the radiant intensity of the light that leaves it in
// one step. Units and layout: lib/render/lpv.h.
#ifndef VOLUME_GLSL
#define VOLUME_GLSL

layout(push_constant) uniform Push
{
    uvec3 size; // voxels
    uint voxels;
    vec3 low;
    float side; // of a voxel, m
    float lift;     // of the look-up, in voxels
    float sharpest; // length that the mean direction of a voxel's light is cut to, below 1
};

// The next step needs the light of a voxel as a lobe of one colour: xyz: its direction times b, 0
// to 1; w: its scale. See lobe_flux.
struct Lobes {
    vec4 red, green, blue;
};

// Second-order spherical harmonics: xyz the coefficients of x, y, z; w that of the constant.
struct Harmonics {
    vec4 red, green, blue;
};

// What passed a voxel in all steps, as irradiance of a plane that faces towards -x, +x, -y, +y, -z,
// +z: of light that goes the other way. Red, green, blue in W; over the area of a voxel's face:
// W/m^2.
struct Passed {
    vec4 by[6];
};

const float SQRT_PI = 1.77245385090552;

// A light's flux (W) and that times its mean direction, as harmonics: their products with
// sqrt(3/(4 pi)) x, y, z and sqrt(1/(4 pi)).
vec4 harmonics_of(vec3 along, float flux)
{
    return vec4(0.5 * sqrt(3.0) * along, 0.5 * flux) / SQRT_PI;
}

float flux_of(vec4 harmonics)
{
    return 2.0 * SQRT_PI * harmonics.w;
}

vec3 along_of(vec4 harmonics)
{
    return 2.0 * SQRT_PI / sqrt(3.0) * harmonics.xyz;
}

// Directions are sorted as a neighbour's faces see them from a voxel's centre: the far one and the
// four at the sides, of which each leads to two neighbours. Solid angles; together they are a sixth
// of the sphere.
const float FAR_ANGLE = 0.400669684624;  // 4 asin(1/10)
const float SIDE_ANGLE = 0.423431354; // (4 pi/6 - that)/4
#ifdef LPV_PRINTED
const vec2 TO_SIDE = vec2(0.894427191, 0.447213595); // to the middle of a face at the side
#else
// Light fills a voxel and does not come from its centre alone: what goes in a direction leaves
// through a side by |x|/(|x| + |y| + |z|) of it. Means over the faces' solid angles, by quadrature.
const float STRAIGHT = 0.763;              // share that stays straight on of light to the far face
const float MAJOR = 0.61;                  // share of light to a side that goes to the nearer axis
const float FAR_MEAN = 0.967;              // length of the mean direction
const vec2 SIDE_MEAN = vec2(0.799, 0.518); // along the nearer and the farther axis
const vec2 TO_SIDE = vec2(0.839, 0.544);   // the same, of length 1
#endif

// What a lobe sends into a direction, b times its cosine with the lobe's being x; not normalised.
// Light with a mean direction of length m is taken as light that a moving observer sees where it
// is isotropic at rest (Levermore 1984): 1/(1 - b cos)^4. printed: the harmonics themselves.
float lobe_shape(float x)
{
#ifdef LPV_PRINTED
    return max(1.0 + 3.0 * x, 0.0);
#else
    float y = 1.0 / (1.0 - x);
    return y * y * y * y;
#endif
}

vec4 lobe_shapes(vec4 x)
{
    return vec4(lobe_shape(x.x), lobe_shape(x.y), lobe_shape(x.z), lobe_shape(x.w));
}

float lobe_through(vec3 b, vec3 ahead, vec3 aside, vec3 up)
{
    vec4 lateral = vec4(dot(b, aside), 0.0, dot(b, up), 0.0);
    lateral.yw = -lateral.xz;
    float a = dot(b, ahead);
    return FAR_ANGLE * lobe_shape(a)
        + SIDE_ANGLE * dot(lobe_shapes(TO_SIDE.x * a + TO_SIDE.y * lateral), vec4(1.0));
}

const vec3 X = vec3(1.0, 0.0, 0.0), Y = vec3(0.0, 1.0, 0.0), Z = vec3(0.0, 0.0, 1.0);

// Scaled so that what goes through all faces of all neighbours is the flux: no energy is made.
// Sharp lobes would follow the volume's axes: what is sharper than `sharpest` is cut to it.
vec4 lobe_of(vec4 harmonics)
{
    float flux = flux_of(harmonics);
    if (!(flux > 0.0))
        return vec4(0.0);
    vec3 m = along_of(harmonics) / flux;
    float size = length(m);
    m *= size > sharpest ? sharpest / size : 1.0;
#ifdef LPV_PRINTED
    vec3 b = m;
#else
    vec3 b = m * (3.0 / (2.0 + sqrt(4.0 - 3.0 * dot(m, m))));
#endif
    float all = lobe_through(b, X, Y, Z) + lobe_through(b, -X, Y, Z) + lobe_through(b, Y, Z, X)
        + lobe_through(b, -Y, Z, X) + lobe_through(b, Z, X, Y) + lobe_through(b, -Z, X, Y);
    return vec4(b, flux / all);
}

Lobes lobes_of(Harmonics h)
{
    return Lobes(lobe_of(h.red), lobe_of(h.green), lobe_of(h.blue));
}

uint voxel_at(uvec3 place)
{
    return place.x + size.x * (place.y + size.y * place.z);
}

uvec3 place_of(uint voxel)
{
    return uvec3(voxel % size.x, voxel / size.x % size.y, voxel / (size.x * size.y));
}

#endif
