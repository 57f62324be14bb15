// Along the normal: a Taylor series up to 1/2, e^-x - 1 by the logarithm beyond, as the authors' shaders do it.
float sg_A_u(float lambda)
{
    const float two_pi = 6.28318530717959;
    float series = 0.5 + lambda * (-1.66666667e-1 + lambda * (4.16666667e-2 + lambda * (-8.33333333e-3
        + lambda * (1.38888889e-3 + lambda * (-1.98412698e-4 + lambda * (2.48015873e-5 + lambda * -2.75573192e-6))))));
    float u = exp(-lambda);
    float y = u - 1.0;
    float over = u == 1.0 ? 1.0 : abs(lambda) < 1.0 ? y / log(u) : -y / lambda;
    return two_pi * (lambda <= 0.5 ? series : (1.0 - over) / lambda);
}
