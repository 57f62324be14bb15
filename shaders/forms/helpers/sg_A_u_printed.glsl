// sg_A_u_printed: A_h of a lobe along the normal, as Meder and Bruederlin print it (eq. 9).
// It cancels for small lambda: in float 2 % off at 1e-3. sg_A_u is the one to use.
real sg_A_u_printed(real lambda)
{
    return K(2.0) * sg_pi / (lambda * lambda) * (exp(-lambda) - K(1.0) + lambda);
}
