// sg_A_b: A_h of a lobe against the normal, pi at 0 and 0 at infinity; no cancellation, no overflow.
// source: Meder and Bruederlin 2018, eq. 10
real sg_A_b(real lambda)
{
    return sg_integral(lambda) * sg_L_b(lambda);
}
