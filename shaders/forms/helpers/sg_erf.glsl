// sg_erf: the error function.
// double: erf
// Up to 1 as x times a polynomial, which keeps the relative error next to 0; beyond 1 the
// complement. In float within 8e-8.
real sg_erf(real x)
{
    real outer = K(1.0) - sg_erfc(abs(x));
    return abs(x) < K(1.0) ? x * sg_erf_over(x) : x < K(0.0) ? -outer : outer;
}
