// The look-up of L with nothing left to compute: both the tail, times sqrt(lambda + 2), and the mean
// length m stand in one texel, over the coordinates of shaders/forms/table.glsl. The sampler clamps.

float sg_L_table(sampler2D table, float lambda, float cos_theta)
{
    float r = inversesqrt(min(lambda, 1e30) + 2.0);
    vec2 place = vec2(0.984375 - 1.9375 * r * r, 0.015625 + 0.21527778 * abs(cos_theta) / r);
    vec2 texel = textureLod(table, place, 0.0).rg;
    return texel.g * max(cos_theta, 0.0) + texel.r * r;
}
