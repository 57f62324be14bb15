// sg_hemisphere_erf: H over A, the share of a lobe's integral that lies in the hemisphere, as Tokuyoshi
// interpolates it between the poles, given its steepness t. The poles' integrals over A are 1/(1 +
// e^-lambda) and e^-lambda/(1 + e^-lambda). 0/0 at lambda = 0, as printed.
// source: Tokuyoshi 2022, eq. 1
real sg_hemisphere_erf(real lambda, real cos_theta, real t)
{
    real e = exp(-lambda);
    real s = K(0.5) + sg_erf(t * cos_theta) / (K(2.0) * sg_erf(t));
    return (s + (K(1.0) - s) * e) / (K(1.0) + e);
}
