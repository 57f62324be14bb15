// constant_cosine_stable: the cosine taken as constant over the lobe; the lobe's integral has gone from L.
// computes: L
// coefficients:
// source: Meder and Bruederlin 2018, eq. 7
real sg_form(real lambda, real cos_theta)
{
    // the sharpness has no part in it, but a NaN there stays one
    return lambda == lambda ? clamp(cos_theta, K(0.0), K(1.0)) : lambda;
}
