// sg_A_h_from_L: A_h of a method whose text computes L.
real sg_A_h_from_L(real L, real lambda)
{
    return L * sg_integral(lambda);
}
