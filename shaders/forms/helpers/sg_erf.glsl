// sg_erf: the error function.
// double: erf
// Up to 1 by powers of 2x^2 - 1 (tables/erf_coefficients.c made them: Chebyshev interpolation of
// degree 6, relative error 1.3e-9), which keeps the relative error next to 0; beyond 1 the
// complement.
real sg_erf(real x)
{
    real size = abs(x);
    real q = K(2.0) * x * x - K(1.0);
    real inner = K(0.96546873867) + q * (K(-0.140536097278) + q * (K(0.0198524971409) + q * (K(-0.00228541954487)
        + q * (K(0.000217513541656) + q * (K(-1.76690680261e-05) + q * K(1.23060547857e-06))))));
    real outer = K(1.0) - sg_erfc(size);
    return size < K(1.0) ? x * inner : x < K(0.0) ? -outer : outer;
}
