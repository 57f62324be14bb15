// constant_cosine: the cosine taken as constant over the lobe, as published: a directional light.
// computes: A_h
// coefficients:
// source: Meder and Bruederlin 2018, eqs 2 and 7
real sg_form(real lambda, real cos_theta)
{
    return max(cos_theta, K(0.0)) * (K(2.0) * sg_pi / lambda * (K(1.0) - exp(K(-2.0) * lambda)));
}
