// meder_logistic: between the poles by clamped and normalised cosine, weighted by a logistic curve, as published.
// computes: A_h
// coefficients: t_scale t_shift u_slope u_offset
// source: Meder and Bruederlin 2018, eqs 15 to 18
// In float NaN from lambda = 88.7 on (e^lambda), and wrong by more than 1e-2 below 2e-3 (A_u
// cancels).
real sg_form(real lambda, real cos_theta)
{
    real t = t_scale * sqrt(lambda) * lambda / (lambda + t_shift);
    real u = K(1.0) / (u_slope * t + u_offset);
    real s = u / (exp(abs(cos_theta) * t) + K(1.0));
    real c = s * (K(0.5) * cos_theta + K(0.5)) + (K(1.0) - s) * max(cos_theta, K(0.0));
    return c * sg_A_u_printed(lambda) + (K(1.0) - c) * sg_A_b_printed(lambda);
}
