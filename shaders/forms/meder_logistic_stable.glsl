// meder_logistic_stable: between the poles by clamped and normalised cosine, weighted by a logistic curve; L from the start.
// computes: L
// coefficients: t_scale t_shift u_slope u_offset
// source: Meder and Bruederlin 2018, eqs 15 to 18
// The poles are A_b/A = sg_L_b and A_u/A = sg_L_b + sg_mean, and the weight of the poles is max(z,
// 0) + s (1 - |z|)/2: a sum of terms that are not negative, so that nothing cancels and no
// exponential grows.
real sg_form(real lambda, real cos_theta)
{
    real z = clamp(cos_theta, K(-1.0), K(1.0));
    real size = abs(z);
    real t = t_scale * sqrt(lambda) * (K(1.0) - t_shift / (lambda + t_shift));
    real u = K(1.0) / (u_slope * t + u_offset);
    real e = exp(-t * size);
    real c = max(z, K(0.0)) + K(0.5) * u * e / (K(1.0) + e) * (K(1.0) - size);
    real value = sg_L_b(lambda) + sg_mean(lambda) * c;
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= K(5.316911983139663e36) ? max(z, K(0.0)) : value;
}
