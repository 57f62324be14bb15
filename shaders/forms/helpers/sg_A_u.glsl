// sg_A_u: A_h of a lobe along the normal, pi at 0 and 0 at infinity; no cancellation.
// source: Meder and Bruederlin 2018, eq. 9
real sg_A_u(real lambda)
{
    return sg_integral(lambda) * (sg_L_b(lambda) + sg_mean(lambda));
}
