// table.glsl: the look-up of L in the table of its tail, plain GLSL.
// `sgfit emit` makes shaders/sg_table.glsl of it. tables/tail.h says what a texel holds.

// L of a lobe of sharpness lambda at cos_theta = dot(axis, normal): the integral of the normalised
// lobe against the clamped cosine, in [0, 1]. Domain: lambda in [0, inf), cos_theta in [-1, 1].
// L = m max(cos_theta, 0) + T: the odd part is exact, the tail T(lambda, |cos_theta|) is looked up.
float sg_L_table(highp sampler2D table, float lambda, float cos_theta)
{
    float root = sqrt(min(lambda, 1e30) + 2.0);
    vec2 place = vec2(1.0 - 2.0 / (root * root), min(abs(cos_theta) * root / 4.5, 1.0));
    float tail = textureLod(table, (31.0 * place + 0.5) / 32.0, 0.0).r / root;
    return sg_mean(lambda) * max(cos_theta, 0.0) + tail;
}

// A_h, the integral of the lobe of amplitude 1 against the clamped cosine, in [0, pi].
float sg_A_h_table(highp sampler2D table, float lambda, float cos_theta)
{
    return sg_L_table(table, lambda, cos_theta) * sg_integral(lambda);
}
