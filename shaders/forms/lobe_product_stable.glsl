// lobe_product_stable: the clamped cosine as one lobe about the normal; exponent and integrals without cancellation.
// computes: L
// coefficients: cosine_amplitude cosine_sharpness
// source: Meder and Bruederlin 2018, eqs 2, 3 and 8
// Sharpnesses in units of their sum, so that no square overflows. Cut at 1, above which the model
// itself goes where cosine_amplitude is more than 1. It tends to cosine_amplitude e^(cosine_sharpness
// (z - 1)) as the sharpness grows; an infinite one gives what is right there, max(z, 0).
real sg_form(real lambda, real cos_theta)
{
    real z = clamp(cos_theta, K(-1.0), K(1.0));
    real sum = lambda + cosine_sharpness;
    real share = lambda / sum;
    real difference = (lambda - cosine_sharpness) / sum;
    real product = sqrt(difference * difference + K(2.0) * share * (cosine_sharpness / sum) * (K(1.0) + z));
    real drop = K(2.0) * cosine_sharpness * (K(1.0) - z);
    real area = sg_integral(sum * product) / sg_integral(lambda);
    real value = min(cosine_amplitude * exp(-drop * share / (K(1.0) + product)) * area, K(1.0));
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= K(5.316911983139663e36) ? max(z, K(0.0)) : value;
}
