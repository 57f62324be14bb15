// sg_tanh_half: tanh(x/2), with full relative precision next to 0.
real sg_tanh_half(real x)
{
    real q = sg_expm1(-abs(x));
    real t = q / (K(2.0) + q);
    return x < K(0.0) ? t : -t;
}
