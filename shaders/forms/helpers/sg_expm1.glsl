// sg_expm1: e^x - 1, without the cancellation next to 0.
// double: expm1
// Below 1/2 as x/(y coth y - y) with y = x/2: its even part is 1 + x^2/12 - x^4/720 + x^6/30240,
// cut where the next term is 3.3e-9 (Bernoulli numbers over factorials). Elsewhere nothing cancels.
real sg_expm1(real x)
{
    real q = x * x;
    real even = K(1.0) + q * (K(0.0833333333333333333) - q * (K(0.00138888888888888889) - q * K(3.30687830687830688e-5)));
    return abs(x) < K(0.5) ? x / (even - K(0.5) * x) : exp(x) - K(1.0);
}
