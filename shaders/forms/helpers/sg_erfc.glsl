// sg_erfc: the complementary error function; 0 at infinity, 2 at minus infinity.
// double: erfc
// e^(-x^2) times a function that varies little, by powers of y = 1 - 5/(x + 2.5)
// (tables/erf_coefficients.c made them: Chebyshev interpolation of degree 10, relative error 8.6e-9);
// near 0, where that would round by more, 1 - erf. In float the rounding of x^2 adds x^2 6e-8 to the
// relative error of the tail.
real sg_erfc(real x)
{
    real size = abs(x);
    real r = K(1.0) / (size + K(2.5));
    real y = K(1.0) - K(5.0) * r;
    real scaled = K(1.05403182031) + y * (K(-0.804651934117) + y * (K(0.453914249745)
        + y * (K(-0.171249418642) + y * (K(0.0283588671095) + y * (K(0.0083828882153)
        + y * (K(-0.00480345510817) + y * (K(-0.000413603799662) + y * (K(0.000666220795278)
        + y * (K(2.68655916139e-05) + y * K(-7.29214562721e-05))))))))));
    real tail = exp(-x * x) * r * scaled;
    real outer = x < K(0.0) ? K(2.0) - tail : tail;
    return size < K(0.75) ? K(1.0) - x * sg_erf_over(x) : outer;
}
