// sg_L_b: L of a lobe against the normal: 1/4 at 0, 0 at infinity.
// (1 - (1 + lambda) e^-lambda)/(lambda (e^lambda - e^-lambda)). L along the normal is sg_L_b + sg_mean.
// Below 1, where the formula cancels, half of the difference between L(z = 1) + L(z = -1), which is
// 1 - tanh(lambda/2)/lambda (by its continued fraction, relative error 9e-11), and sg_mean.
real sg_L_b(real lambda)
{
    real q = lambda * lambda;
    real sum = K(0.5) * (K(1.0) + q * (K(0.194444444444444444) + q * K(0.00191798941798941799)))
        / (K(1.0) + q * (K(0.111111111111111111) + q * K(0.000992063492063492063)));
    real e = exp(-lambda);
    real outer = e / (K(1.0) + e) * (K(1.0) / lambda - e / (K(1.0) - e));
    return lambda < K(1.0) ? K(0.5) * (sum - sg_mean(lambda)) : outer;
}
