// lobe_product: the clamped cosine as one lobe about the normal; the product's integral, as published.
// computes: A_h
// coefficients: cosine_amplitude cosine_sharpness
// source: Meder and Bruederlin 2018, eqs 2, 3 and 8
// The exponent cancels (in float all of it is lost by lambda = 1e8); opposite lobes of equal
// sharpness give 0/0.
real sg_form(real lambda, real cos_theta)
{
    real sharpness = sqrt(lambda * lambda + cosine_sharpness * cosine_sharpness
        + K(2.0) * lambda * cosine_sharpness * cos_theta);
    real amplitude = cosine_amplitude * exp(sharpness - lambda - cosine_sharpness);
    return amplitude * (K(2.0) * sg_pi) / sharpness * (K(1.0) - exp(K(-2.0) * sharpness));
}
