// pettineo_hill: Pettineo's and Hill's fit of the irradiance, as published.
// computes: A_h
// coefficients: c0
// source: Pettineo and Hill 2016 (SG Series, part 3)
// For lambda >= 1 only: below it diverges, is negative below 0.58 and is NaN where 1 - scale is not
// positive.
real sg_form(real lambda, real cos_theta)
{
    real c1 = K(1.0) / (K(4.0) * c0);
    real e = exp(-lambda);
    real e2 = e * e;
    real r = K(1.0) / lambda;
    real scale = K(1.0) + K(2.0) * e2 - r;
    real bias = (e - e2) * r - e2;
    real x = sqrt(K(1.0) - scale);
    real x0 = c0 * cos_theta;
    real x1 = c1 * x;
    real n = x0 + x1;
    real y = abs(x0) <= x1 ? n * n / x : max(cos_theta, K(0.0));
    return (scale * y + bias) * (K(2.0) * sg_pi) * r;
}
