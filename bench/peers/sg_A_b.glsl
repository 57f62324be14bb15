// Against the normal, in the same way.
float sg_A_b(float lambda)
{
    const float two_pi = 6.28318530717959;
    float e = exp(-lambda);
    float series = 0.5 + lambda * (-3.33333333e-1 + lambda * (0.125 + lambda * (-3.33333333e-2
        + lambda * (6.94444444e-3 + lambda * (-1.19047619e-3 + lambda * (1.73611111e-4 + lambda * (-2.20458554e-5
        + lambda * 2.48015873e-6)))))));
    float y = e - 1.0;
    float over = e == 1.0 ? 1.0 : abs(lambda) < 1.0 ? y / log(e) : -y / lambda;
    return two_pi * e * (lambda <= 0.5 ? series : (over - e) / lambda);
}
