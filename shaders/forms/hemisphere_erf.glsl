// hemisphere_erf: the clamped cosine as a lobe less a constant, hemispheres by an error function, as published.
// computes: L
// coefficients: cosine_sharpness alpha t_0 t_1 t_2
// source: Tokuyoshi 2022, sections 2 and 3
// L = alpha (p - q), p and q hemispheres of the product and of the lobe over A, cut at 0. The
// product's exponent and the integrals are written without cancellation, as the poster's results
// were computed; what float still loses is the rounding of p and q, enlarged by alpha, which is
// 1182. p and q lie within a factor of 2 of each other, so that p - q is exact and Kahan's
// difference of alpha p and alpha q could not do better.
real sg_form(real lambda, real cos_theta)
{
    real sharpness = sqrt(lambda * lambda + cosine_sharpness * cosine_sharpness
        + K(2.0) * lambda * cosine_sharpness * cos_theta);
    real cosine = (lambda * cos_theta + cosine_sharpness) / sharpness;
    real t = lambda * sqrt((K(0.5) * lambda + t_0) / (lambda * lambda + t_1 * lambda + t_2));
    real t3 = sharpness * sqrt((K(0.5) * sharpness + t_0) / (sharpness * sharpness + t_1 * sharpness + t_2));
    // e^lambda_c times the product's amplitude is e^(sharpness - lambda)
    real exponent = cosine_sharpness * (K(2.0) * lambda * cos_theta + cosine_sharpness) / (sharpness + lambda);
    real p = exp(exponent) * sg_integral(sharpness) / sg_integral(lambda) * sg_hemisphere_erf(sharpness, cosine, t3);
    real q = sg_hemisphere_erf(lambda, cos_theta, t);
    return max(alpha * (p - q), K(0.0));
}
