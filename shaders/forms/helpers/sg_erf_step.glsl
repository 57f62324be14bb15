// sg_erf_step: (erf(x + h/2) - erf(x - h/2))/h for a small step h, without the difference.
// The midpoint rule and its first correction: relative error below h^4/100.
real sg_erf_step(real x, real h)
{
    real q = x * x;
    return K(1.12837916709551257) * exp(-q) * (K(1.0) + h * h * (K(2.0) * q - K(1.0)) * K(0.0833333333333333333));
}
