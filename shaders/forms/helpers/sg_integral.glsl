// sg_integral: A, the integral of a lobe of amplitude 1 over the sphere, 4 pi at 0 and 0 at infinity.
// source: Meder and Bruederlin 2018, eq. 2
real sg_integral(real lambda)
{
    return K(4.0) * sg_pi * sg_one_minus_exp_over(K(2.0) * lambda);
}
