// cosine_erf: between the poles by the integral of a planar Gaussian times a clamped plane, as published.
// computes: A_h
// coefficients: t_a t_b t_c t_d t_e
// source: Tokuyoshi et al. 2024 (Hierarchical Light Sampling with Accurate Spherical Gaussian Lighting), supplement
// 0/0 at lambda = 0. A_u and A_b are taken without cancellation; in float nothing else is lost.
real sg_form(real lambda, real cos_theta)
{
    real t = lambda * sqrt(K(0.5) * (lambda * lambda + t_a * lambda + t_b)
        / (lambda * lambda * lambda + t_c * lambda * lambda + t_d * lambda + t_e));
    real s = K(0.5) * (cos_theta * sg_erfc(-t * cos_theta) + sg_erfc(t))
        - exp(-t * t * cos_theta * cos_theta) * sg_expm1(t * t * (cos_theta * cos_theta - K(1.0)))
        / (K(2.0) * t * sqrt(sg_pi));
    real lower = sg_A_b(lambda);
    return lower + s * (sg_A_u(lambda) - lower);
}
