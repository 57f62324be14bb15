// sg_A_b_printed: A_h of a lobe against the normal, as Meder and Bruederlin print it (eq. 10).
// double: sg_A_b
// e^lambda overflows: NaN in float from lambda = 88.7 on. In double the print would be NaN from 709
// on and leave no model to be measured there, so the double unit has sg_A_b instead, which is the
// same function without the overflow. sg_A_b is the one to use.
real sg_A_b_printed(real lambda)
{
    return K(2.0) * sg_pi / (lambda * lambda) * exp(K(-2.0) * lambda) * (exp(lambda) - K(1.0) - lambda);
}
