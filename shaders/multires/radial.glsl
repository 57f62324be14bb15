// radial.glsl: Gaussian radial basis functions through up to three samples (3.1.5).
#ifndef RADIAL_GLSL
#define RADIAL_GLSL

const float RADIAL_C = 2.0;
const float RADIAL_LEAST = 1e-4; // determinant of the 3 x 3 system below which it is not solved

float radial(vec2 a, vec2 b, float width)
{
    vec2 d = (a - b) / width;
    return exp(-dot(d, d) / RADIAL_C);
}

// Value at p of the combination of three bases that takes the three values at their places, its
// shares of them divided by their sum, so that a constant stays one; bounded by the three values.
// The weighted form of the same bases where the system is too near to being singular.
vec3 radial_three(vec2 p, vec2 at[3], vec3 values[3], float width)
{
    float a = radial(at[0], at[1], width), b = radial(at[0], at[2], width);
    float c = radial(at[1], at[2], width);
    vec3 here = vec3(radial(p, at[0], width), radial(p, at[1], width), radial(p, at[2], width));
    float det = 1.0 + 2.0 * a * b * c - a * a - b * b - c * c;
    vec3 share = here / (here.x + here.y + here.z);
    if (det > RADIAL_LEAST) {
        // the inverse is symmetric: its product with the bases here, not with the values
        share = vec3((1.0 - c * c) * here.x + (b * c - a) * here.y + (a * c - b) * here.z,
                     (b * c - a) * here.x + (1.0 - b * b) * here.y + (a * b - c) * here.z,
                     (a * c - b) * here.x + (a * b - c) * here.y + (1.0 - a * a) * here.z);
        share /= share.x + share.y + share.z;
    }
    vec3 value = share.x * values[0] + share.y * values[1] + share.z * values[2];
    return clamp(value, min(values[0], min(values[1], values[2])),
                 max(values[0], max(values[1], values[2])));
}

vec3 radial_two(vec2 p, vec2 at0, vec2 at1, vec3 value0, vec3 value1, float width)
{
    float a = radial(p, at0, width), b = radial(p, at1, width);
    return (a * value0 + b * value1) / (a + b);
}

#endif
