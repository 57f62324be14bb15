// hemisphere_logistic: the clamped cosine as a lobe less a constant, hemispheres by a logistic curve, as published.
// computes: A_h
// coefficients: cosine_amplitude cosine_sharpness cosine_offset t_cubic t_square t_linear t_constant
// source: Meder and Bruederlin 2018 (Hemispherical Gaussians)
// Two numbers of about 32 are subtracted and the exponent cancels: in float 0.03 is lost at lambda
// = 1e4. e^-t rounds to 1 below lambda = 1e-5: NaN there.
real sg_form(real lambda, real cos_theta)
{
    real sharpness = sqrt(lambda * lambda + cosine_sharpness * cosine_sharpness
        + K(2.0) * lambda * cosine_sharpness * cos_theta);
    real cosine = (lambda * cos_theta + cosine_sharpness) / sharpness;
    real t = sqrt(lambda) * (t_cubic * lambda * lambda + t_square * lambda)
        / (lambda * lambda + t_linear * lambda + t_constant);
    real t3 = sqrt(sharpness) * (t_cubic * sharpness * sharpness + t_square * sharpness)
        / (sharpness * sharpness + t_linear * sharpness + t_constant);
    return cosine_amplitude * exp(sharpness - lambda - cosine_sharpness) * sg_hemisphere_logistic(sharpness, cosine, t3)
        - cosine_offset * sg_hemisphere_logistic(lambda, cos_theta, t);
}
