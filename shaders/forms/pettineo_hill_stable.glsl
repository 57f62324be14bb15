// pettineo_hill_stable: Pettineo's and Hill's fit from lambda = 1 up, below it a Hermite continuation to the exact 1/4.
// computes: L
// coefficients: c0
// source: Pettineo and Hill 2016 (SG Series, part 3)
// 1 - scale is formed as 1/lambda - 2 e^-2lambda, which does not cancel. Below lambda = 1, where
// the fit diverges, the Hermite continuation: the cubic in lambda with the fit's own value and
// slope at 1 and, at 0, the integral's value 1/4 and slope z/6 (both exact).
real sg_form(real lambda, real cos_theta)
{
    real z = clamp(cos_theta, K(-1.0), K(1.0));
    real l = max(lambda, K(1.0));
    real c1 = K(1.0) / (K(4.0) * c0);
    real e = exp(-l);
    real e2 = e * e;
    real r = K(1.0) / l;
    real rest = r - K(2.0) * e2;
    real scale = K(1.0) - rest;
    real bias = (e - e2) * r - e2;
    real area = K(1.0) - e2;
    real x = sqrt(rest);
    real x0 = c0 * z;
    real x1 = c1 * x;
    real n = x0 + x1;
    bool inside = abs(x0) <= x1;
    real y = inside ? n * (n / x) : max(z, K(0.0));
    real value = (scale * y + bias) / area;
    // the slope in lambda; used at l = 1 only, where every z is inside
    real scale_slope = r * r - K(4.0) * e2;
    real bias_slope = (K(2.0) * e2 - e) * r - (e - e2) * r * r + K(2.0) * e2;
    real y_slope = (n / x) * (n / x - K(2.0) * c1) * scale_slope / (K(2.0) * x);
    real slope = (scale_slope * y + scale * y_slope + bias_slope - K(2.0) * e2 * value) / area;
    real start = z * K(0.166666666666666667);
    real rise = value - K(0.25);
    real below = K(0.25) + lambda * (start + lambda * (K(3.0) * rise - K(2.0) * start - slope
        + lambda * (start + slope - K(2.0) * rise)));
    real found = lambda < K(1.0) ? below : value;
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= K(5.316911983139663e36) ? max(z, K(0.0)) : found;
}
