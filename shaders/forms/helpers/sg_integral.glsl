// sg_integral: A, the integral of a lobe of amplitude 1 over the sphere, 4 pi at 0 and 0 at infinity.
// source: Meder and Bruederlin 2018, eq. 2
real sg_integral(real lambda)
{
    // next to 0 the quotient's own series, so that nothing is divided by 0
    real share = lambda < K(1.0e-5) ? K(2.0) - K(2.0) * lambda * (K(1.0) - K(0.666666666666666667) * lambda)
        : -sg_expm1(K(-2.0) * lambda) / lambda;
    return K(2.0) * sg_pi * share;
}
