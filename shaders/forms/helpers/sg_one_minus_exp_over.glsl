// sg_one_minus_exp_over: (1 - e^-x)/x for x >= 0, 1 at 0.
real sg_one_minus_exp_over(real x)
{
    // next to 0 the quotient's own series, so that nothing is divided by 0
    return x < K(1.0e-5) ? K(1.0) - K(0.5) * x * (K(1.0) - K(0.333333333333333333) * x) : -sg_expm1(-x) / x;
}
