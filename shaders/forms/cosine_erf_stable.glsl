// cosine_erf_stable: between the poles by the integral of a planar Gaussian times a clamped plane; L from the start.
// computes: L
// coefficients: t_a t_b t_c t_d t_e
// source: Tokuyoshi et al. 2024 (Hierarchical Light Sampling with Accurate Spherical Gaussian Lighting), supplement
// The steepness is written in v = 1/(1 + lambda), so that no power of lambda overflows, and
// expm1(y)/t as t expm1(y)/t^2, which is not 0/0 at lambda = 0.
real sg_form(real lambda, real cos_theta)
{
    real z = clamp(cos_theta, K(-1.0), K(1.0));
    real v = K(1.0) / (K(1.0) + lambda);
    real w = K(1.0) - v;
    real above = w * w + v * (t_a * w + t_b * v);
    real below = w * w * w + v * (t_c * w * w + v * (t_d * w + t_e * v));
    real t = lambda * sqrt(K(0.5) * v * above / below);
    real side = (K(1.0) - z) * (K(1.0) + z);
    real bell = exp(-(t * z) * (t * z)) * side * t * sg_one_minus_exp_over(t * t * side);
    // 1/(2 sqrt(pi))
    real s = K(0.5) * (z * sg_erfc(-t * z) + sg_erfc(t)) + K(0.282094791773878143) * bell;
    real value = max(sg_L_b(lambda) + sg_mean(lambda) * s, K(0.0));
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= K(5.316911983139663e36) ? max(z, K(0.0)) : value;
}
