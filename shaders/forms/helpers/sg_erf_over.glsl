// sg_erf_over: erf(x)/x for |x| <= 1.
// Powers of 2x^2 - 1 (tables/erf_coefficients.c made them: Chebyshev interpolation of degree 6,
// relative error 1.3e-9).
real sg_erf_over(real x)
{
    real q = K(2.0) * x * x - K(1.0);
    return K(0.96546873867) + q * (K(-0.140536097278) + q * (K(0.0198524971409)
        + q * (K(-0.00228541954487) + q * (K(0.000217513541656)
        + q * (K(-1.76690680261e-05) + q * K(1.23060547857e-06))))));
}
