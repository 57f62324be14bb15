// sg_table.glsl: the clamped-cosine integral of a spherical Gaussian from a look-up table.
// Written by `sgfit emit`; do not edit.
//
// To integrate: include this file after #version (450, 330, 300 es or later), with sg.glsl or
// without, and pass a sampler of tables/out/tail_32_half.exr or tail_32_float.exr as a
// one-channel texture: 32 x 32, row 0 first, linear filter, clamped to edge, no mipmap. In GLSL
// ES write `precision highp float;` before it; linear filtering of a float texture needs
// OES_texture_float_linear there, of a half one nothing. tables/out/README.md states the errors.
#ifndef SG_TABLE_GLSL
#define SG_TABLE_GLSL

// sg_table_mean: mean resultant length of a lobe, coth lambda - 1/lambda: 0 at 0, 1 at infinity. It
// is also L(lambda, z) - L(lambda, -z) over z, exactly, for every z. Below 1 its continued fraction
// lambda/(3 + lambda^2/(5 + lambda^2/(7 + ...))) cut after 13: relative error 9e-12.
float sg_table_mean(float lambda)
{
    float q = lambda * lambda;
    float inner = lambda * 0.333333333333333333 * (1.0 + q * (0.0615384615384615385 + q * 0.000599400599400599401))
        / (1.0 + q * (0.128205128205128205 + q * (0.00279720279720279720 + q * 7.40000740000740001e-6)));
    float e = exp(-2.0 * lambda);
    float outer = (1.0 + e) / (1.0 - e) - 1.0 / lambda;
    return lambda < 1.0 ? inner : outer;
}

// sg_table_expm1: e^x - 1, without the cancellation next to 0. Below 1/2 as x/(y coth y - y) with y
// = x/2: its even part is 1 + x^2/12 - x^4/720 + x^6/30240, cut where the next term is 3.3e-9
// (Bernoulli numbers over factorials). Elsewhere nothing cancels.
float sg_table_expm1(float x)
{
    float q = x * x;
    float even = 1.0 + q * (0.0833333333333333333 - q * (0.00138888888888888889 - q * 3.30687830687830688e-5));
    return abs(x) < 0.5 ? x / (even - 0.5 * x) : exp(x) - 1.0;
}

// sg_table_integral: A, the integral of a lobe of amplitude 1 over the sphere, 4 pi at 0 and 0 at
// infinity.
// Source: Meder and Bruederlin 2018, eq. 2
float sg_table_integral(float lambda)
{
    const float sg_pi = 3.14159265358979;
    // next to 0 the quotient's own series, so that nothing is divided by 0
    float share = lambda < 1.0e-5 ? 2.0 - 2.0 * lambda * (1.0 - 0.666666666666666667 * lambda)
        : -sg_table_expm1(-2.0 * lambda) / lambda;
    return 2.0 * sg_pi * share;
}

// L of a lobe of sharpness lambda at cos_theta = dot(axis, normal): the integral of the normalised
// lobe against the clamped cosine, in [0, 1]. Domain: lambda in [0, inf), cos_theta in [-1, 1].
// L = m max(cos_theta, 0) + T: the odd part is exact, the tail T(lambda, |cos_theta|) is looked up.
float sg_L_table(highp sampler2D table, float lambda, float cos_theta)
{
    float root = sqrt(min(lambda, 1e30) + 2.0);
    vec2 place = vec2(1.0 - 2.0 / (root * root), min(abs(cos_theta) * root / 4.5, 1.0));
    float tail = textureLod(table, (31.0 * place + 0.5) / 32.0, 0.0).r / root;
    return sg_table_mean(lambda) * max(cos_theta, 0.0) + tail;
}

// A_h, the integral of the lobe of amplitude 1 against the clamped cosine, in [0, pi].
float sg_A_h_table(highp sampler2D table, float lambda, float cos_theta)
{
    return sg_L_table(table, lambda, cos_theta) * sg_table_integral(lambda);
}

#endif
