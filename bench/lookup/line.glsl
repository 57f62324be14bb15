// Meder's logistic with its steepness t and height u looked up over lambda/(lambda + 2), 128 texels of one
// dimension: t r, u/r, L at beta = pi over r, and m, with r = 1/sqrt(lambda + 2).

float sg_L_table(sampler1D table, float lambda, float cos_theta)
{
    float r = inversesqrt(min(lambda, 1e30) + 2.0);
    vec4 texel = textureLod(table, 0.99609375 - 1.984375 * r * r, 0.0);
    float size = abs(cos_theta);
    float weight = texel.y * r / (exp(size * texel.x / r) + 1.0);
    return texel.w * (max(cos_theta, 0.0) + (0.5 - 0.5 * size) * weight) + texel.z * r;
}
