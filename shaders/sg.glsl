// sg.glsl: integrals of spherical Gaussians against the clamped cosine.
// Written by `sgfit emit`; do not edit.
//
// To integrate: paste or #include this file after #version (450, 330, 300 es or later). It
// defines functions and one struct, all named sg_, and the guard SG_GLSL; no binding, no
// global, no other macro. In GLSL ES write `precision highp float;` before it: mediump is half
// on many devices, for which none of the errors below hold. Then, per light:
//
//     irradiance += sg_irradiance(amplitude, axis, sharpness, normal);
//
// sg_irradiance calls sg_A_h_standard. Functions of one lobe of amplitude 1 take
// (lambda, cos_theta): its sharpness and dot(axis, normal).
//   A_h  integral of exp(lambda (dot(w, axis) - 1)) max(dot(w, normal), 0) over the sphere
//   L    A_h over the integral of the lobe alone: the same for a lobe that integrates to 1
//
// Errors are of L against the integral over 400 sharpnesses, logarithmic on [1e-3, 1e4], times
// 1001 angles beta, uniform on [0, pi], as far as they lie in the method's domain. Costs are
// instructions that RADV needs for the function on navi21, without the shader around it.
// Methods as published may fail at the ends of their domain; those named _stable are the same
// models without that, and all others are stable too.
//
//   method                       max error  RMSE      A_h costs  what it is
//   wang_2009                    1.71e-01   4.91e-02  15         Cosine as a lobe, the common fit
//   wang_2009_stable             1.35e-01   4.08e-02  105        Cosine as a lobe, the common fit, stable
//   pettineo_hill_2016           3.67e-02   5.28e-03  22         Fitted irradiance of Pettineo and Hill
//   pettineo_hill_2016_stable    3.67e-02   4.55e-03  82         Fitted irradiance of Pettineo and Hill, Hermite continuation below lambda = 1
//   tokuyoshi_2016               1.54e-01   5.37e-02  15         Cosine as a lobe of sharpness 2
//   tokuyoshi_2016_stable        1.53e-01   5.37e-02  104        Cosine as a lobe of sharpness 2, stable
//   constant_cosine              7.50e-01   2.56e-01  8          Cosine constant over the lobe
//   constant_cosine_stable       7.50e-01   2.56e-01  29         Cosine constant over the lobe, stable
//   meder_2018                   inf        inf       38         Logistic between the poles
//   meder_2018_hg                3.48e-02   3.24e-03  75         Hemispherical Gaussians, logistic
//   meder_2018_hg_stable         1.11e-02   2.86e-03  316        Hemispherical Gaussians, logistic, stable
//   meder_2018_stable            5.28e-03   7.98e-04  97         Logistic between the poles, stable
//   tokuyoshi_2022               3.93e-03   5.60e-04  322        Hemispherical Gaussians, error function
//   tokuyoshi_2022_stable        3.69e-03   5.57e-04  384        Hemispherical Gaussians, error function, stable
//   tokuyoshi_2024               1.28e-03   1.94e-04  219        Planar Gaussian between the poles
//   tokuyoshi_2024_stable        1.28e-03   1.94e-04  202        Planar Gaussian between the poles, stable
//   brisk                        4.80e-04   2.40e-04  47         Root over a Gaussian bell, one term
//   fine                         5.77e-07   1.89e-07  94         Root over a Gaussian bell, five terms
//   logistic_minimax             6.61e-04   1.36e-04  108        Logistic with the exact limits, minimax
//   logistic_refit               7.33e-04   1.15e-04  108        Logistic with the exact limits, least squares
//   meder_2018_minimax           2.31e-03   5.21e-04  97         Logistic between the poles, minimax
//   meder_2018_refit             2.91e-03   4.70e-04  97         Logistic between the poles, least squares
//   medium                       9.83e-05   3.09e-05  53         Root over a Gaussian bell, two terms
//   positive                     5.03e-04   2.30e-04  76         Root with a true tail
//   quick                        9.95e-04   5.11e-04  46         Root over a quartic bell
//   split                        1.01e-05   3.89e-06  71         Root over a Gaussian bell in cos_theta
//   standard                     6.71e-06   3.93e-06  71         Root over a Gaussian bell, three terms
//   tokuyoshi_2022_minimax       2.88e-03   5.92e-04  384        Hemispherical Gaussians, error function, minimax
//   tokuyoshi_2022_refit         2.98e-03   4.78e-04  384        Hemispherical Gaussians, error function, least squares
//   tokuyoshi_2024_minimax       1.19e-03   2.33e-04  202        Planar Gaussian between the poles, minimax
//   tokuyoshi_2024_refit         1.22e-03   1.93e-04  202        Planar Gaussian between the poles, least squares
#ifndef SG_GLSL
#define SG_GLSL

// sg_mean: mean resultant length of a lobe, coth lambda - 1/lambda: 0 at 0, 1 at infinity. It is
// also L(lambda, z) - L(lambda, -z) over z, exactly, for every z. Below 1 its continued fraction
// lambda/(3 + lambda^2/(5 + lambda^2/(7 + ...))) cut after 13: relative error 9e-12.
float sg_mean(float lambda)
{
    float q = lambda * lambda;
    float inner = lambda * 0.333333333333333333 * (1.0 + q * (0.0615384615384615385 + q * 0.000599400599400599401))
        / (1.0 + q * (0.128205128205128205 + q * (0.00279720279720279720 + q * 7.40000740000740001e-6)));
    float e = exp(-2.0 * lambda);
    float outer = (1.0 + e) / (1.0 - e) - 1.0 / lambda;
    return lambda < 1.0 ? inner : outer;
}

// sg_L_b: L of a lobe against the normal: 1/4 at 0, 0 at infinity. (1 - (1 + lambda)
// e^-lambda)/(lambda (e^lambda - e^-lambda)). L along the normal is sg_L_b + sg_mean. Below 1,
// where the formula cancels, half of the difference between L(z = 1) + L(z = -1), which is 1 -
// tanh(lambda/2)/lambda (by its continued fraction, relative error 9e-11), and sg_mean.
float sg_L_b(float lambda)
{
    float q = lambda * lambda;
    float sum = 0.5 * (1.0 + q * (0.194444444444444444 + q * 0.00191798941798941799))
        / (1.0 + q * (0.111111111111111111 + q * 0.000992063492063492063));
    float e = exp(-lambda);
    float outer = e / (1.0 + e) * (1.0 / lambda - e / (1.0 - e));
    return lambda < 1.0 ? 0.5 * (sum - sg_mean(lambda)) : outer;
}

// sg_expm1: e^x - 1, without the cancellation next to 0. Below 1/2 as x/(y coth y - y) with y =
// x/2: its even part is 1 + x^2/12 - x^4/720 + x^6/30240, cut where the next term is 3.3e-9
// (Bernoulli numbers over factorials). Elsewhere nothing cancels.
float sg_expm1(float x)
{
    float q = x * x;
    float even = 1.0 + q * (0.0833333333333333333 - q * (0.00138888888888888889 - q * 3.30687830687830688e-5));
    return abs(x) < 0.5 ? x / (even - 0.5 * x) : exp(x) - 1.0;
}

// sg_integral: A, the integral of a lobe of amplitude 1 over the sphere, 4 pi at 0 and 0 at
// infinity.
// Source: Meder and Bruederlin 2018, eq. 2
float sg_integral(float lambda)
{
    const float sg_pi = 3.14159265358979;
    // next to 0 the quotient's own series, so that nothing is divided by 0
    float share = lambda < 1.0e-5 ? 2.0 - 2.0 * lambda * (1.0 - 0.666666666666666667 * lambda)
        : -sg_expm1(-2.0 * lambda) / lambda;
    return 2.0 * sg_pi * share;
}

// sg_A_b: A_h of a lobe against the normal, pi at 0 and 0 at infinity; no cancellation, no
// overflow.
// Source: Meder and Bruederlin 2018, eq. 10
float sg_A_b(float lambda)
{
    return sg_integral(lambda) * sg_L_b(lambda);
}

// sg_A_b_printed: A_h of a lobe against the normal, as Meder and Bruederlin print it (eq. 10).
// e^lambda overflows: NaN in float from lambda = 88.7 on. In double the print would be NaN from 709
// on and leave no model to be measured there, so the double unit has sg_A_b instead, which is the
// same function without the overflow. sg_A_b is the one to use.
float sg_A_b_printed(float lambda)
{
    const float sg_pi = 3.14159265358979;
    return 2.0 * sg_pi / (lambda * lambda) * exp(-2.0 * lambda) * (exp(lambda) - 1.0 - lambda);
}

// sg_A_h_from_L: A_h of a method whose text computes L.
float sg_A_h_from_L(float L, float lambda)
{
    return L * sg_integral(lambda);
}

// sg_A_u: A_h of a lobe along the normal, pi at 0 and 0 at infinity; no cancellation.
// Source: Meder and Bruederlin 2018, eq. 9
float sg_A_u(float lambda)
{
    return sg_integral(lambda) * (sg_L_b(lambda) + sg_mean(lambda));
}

// sg_A_u_printed: A_h of a lobe along the normal, as Meder and Bruederlin print it (eq. 9). It
// cancels for small lambda: in float 2 % off at 1e-3. sg_A_u is the one to use.
float sg_A_u_printed(float lambda)
{
    const float sg_pi = 3.14159265358979;
    return 2.0 * sg_pi / (lambda * lambda) * (exp(-lambda) - 1.0 + lambda);
}

// sg_L_from_A_h: L of a method whose text computes A_h. Where the integral over the sphere has run
// out of range (an infinite sharpness) the quotient's limit, the clamped cosine; NaN stays NaN.
float sg_L_from_A_h(float A_h, float lambda, float cos_theta)
{
    float area = sg_integral(lambda);
    return area == 0.0 ? max(cos_theta, 0.0) : A_h / area;
}

// sg_erf_over: erf(x)/x for |x| <= 1. Powers of 2x^2 - 1 (tables/erf_coefficients.c made them:
// Chebyshev interpolation of degree 6, relative error 1.3e-9).
float sg_erf_over(float x)
{
    float q = 2.0 * x * x - 1.0;
    return 0.96546873867 + q * (-0.140536097278 + q * (0.0198524971409
        + q * (-0.00228541954487 + q * (0.000217513541656
        + q * (-1.76690680261e-05 + q * 1.23060547857e-06)))));
}

// sg_erfc: the complementary error function; 0 at infinity, 2 at minus infinity. e^(-x^2) times a
// function that varies little, by powers of y = 1 - 5/(x + 2.5) (tables/erf_coefficients.c made
// them: Chebyshev interpolation of degree 10, relative error 8.6e-9); near 0, where that would
// round by more, 1 - erf. In float the rounding of x^2 adds x^2 6e-8 to the relative error of the
// tail.
float sg_erfc(float x)
{
    float size = abs(x);
    float r = 1.0 / (size + 2.5);
    float y = 1.0 - 5.0 * r;
    float scaled = 1.05403182031 + y * (-0.804651934117 + y * (0.453914249745
        + y * (-0.171249418642 + y * (0.0283588671095 + y * (0.0083828882153
        + y * (-0.00480345510817 + y * (-0.000413603799662 + y * (0.000666220795278
        + y * (2.68655916139e-05 + y * (-7.29214562721e-05))))))))));
    float tail = exp(-x * x) * r * scaled;
    float outer = x < 0.0 ? 2.0 - tail : tail;
    return size < 0.75 ? 1.0 - x * sg_erf_over(x) : outer;
}

// sg_erf: the error function. Up to 1 as x times a polynomial, which keeps the relative error next
// to 0; beyond 1 the complement. In float within 8e-8.
float sg_erf(float x)
{
    float outer = 1.0 - sg_erfc(abs(x));
    return abs(x) < 1.0 ? x * sg_erf_over(x) : x < 0.0 ? -outer : outer;
}

// sg_erf_step: (erf(x + h/2) - erf(x - h/2))/h for a small step h, without the difference. The
// midpoint rule and its first correction: relative error below h^4/100.
float sg_erf_step(float x, float h)
{
    float q = x * x;
    return 1.12837916709551257 * exp(-q) * (1.0 + h * h * (2.0 * q - 1.0) * 0.0833333333333333333);
}

// sg_evaluate_near: a lobe of amplitude 1 in a direction, in [0, 1], from |direction - axis|^2 in
// [0, 4]. That square is 2 - 2 cos theta, and does not round to 0 next to the axis.
float sg_evaluate_near(float lambda, float difference_squared)
{
    return exp(-0.5 * lambda * difference_squared);
}

// sg_gain_step: (Q - 1)/step, Q = sinh(product)/product over sinh(lambda)/lambda, product = lambda
// + step. Q is what the integral of a lobe over the sphere gains when the lobe is multiplied by
// e^(c (w.n)) and has the sharpness `product` afterwards. |step| < 0.05. No difference of nearly
// equal numbers: below 1 the divided difference of the power series in x^2 (cut where 6/13!
// follows), elsewhere Q - 1 = (lambda (cosh step - 1) + lambda coth(lambda) sinh(step) -
// step)/product.
float sg_gain_step(float lambda, float product, float step)
{
    float q = lambda * lambda;
    float p = product * product;
    float s1 = p + q;
    float s2 = p * s1 + q * q;
    float s3 = p * s2 + q * q * q;
    float s4 = p * s3 + q * q * q * q;
    float slope = 0.166666666666666667 + 0.00833333333333333333 * s1 + 1.98412698412698413e-4 * s2
        + 2.75573192239858907e-6 * s3 + 2.50521083854417188e-8 * s4;
    float sinhc = 1.0 + q * (0.166666666666666667 + q * (0.00833333333333333333 + q * (1.98412698412698413e-4
        + q * (2.75573192239858907e-6 + q * 2.50521083854417188e-8))));
    float mean = sg_mean(lambda);
    float ratio = lambda / product;
    float h = step * step;
    float outer = ratio * (mean + 0.5 * step * (1.0 + h * 0.0833333333333333333))
        + (1.0 / product + ratio * mean) * h * (0.166666666666666667 + h * 0.00833333333333333333);
    return lambda < 1.0 ? (lambda + product) * slope / sinhc : outer;
}

// sg_hemisphere_erf: H over A, the share of a lobe's integral that lies in the hemisphere, as
// Tokuyoshi interpolates it between the poles, given its steepness t. The poles' integrals over A
// are 1/(1 + e^-lambda) and e^-lambda/(1 + e^-lambda). 0/0 at lambda = 0, as printed.
// Source: Tokuyoshi 2022, eq. 1
float sg_hemisphere_erf(float lambda, float cos_theta, float t)
{
    float e = exp(-lambda);
    float s = 0.5 + sg_erf(t * cos_theta) / (2.0 * sg_erf(t));
    return (s + (1.0 - s) * e) / (1.0 + e);
}

// sg_hemisphere_logistic: H, the integral of a lobe over the hemisphere, by a normalised logistic
// of steepness t. As published, s = (ab - 1)/((a - 1)(b + 1)) with a = e^t and b = e^(tz), in the
// reciprocals a' = e^-t and b' = e^-t|z| in which public implementations evaluate it, because a
// overflows. 0/0 where a' rounds to 1.
// Source: Meder and Bruederlin 2018 (Hemispherical Gaussians)
float sg_hemisphere_logistic(float lambda, float cos_theta, float t)
{
    const float sg_pi = 3.14159265358979;
    float upper = 2.0 * sg_pi * (1.0 - exp(-lambda)) / lambda;
    float lower = exp(-lambda) * upper;
    float a = exp(-t);
    float b = exp(-t * abs(cos_theta));
    float s = (cos_theta < 0.0 ? b - a : 1.0 - a * b) / ((1.0 - a) * (1.0 + b));
    return lower + s * (upper - lower);
}

// sg_one_minus_exp_over: (1 - e^-x)/x for x >= 0, 1 at 0.
float sg_one_minus_exp_over(float x)
{
    // next to 0 the quotient's own series, so that nothing is divided by 0
    return x < 1.0e-5 ? 1.0 - 0.5 * x * (1.0 - 0.333333333333333333 * x) : -sg_expm1(-x) / x;
}

// sg_product_log_amplitude: logarithm of what the amplitude of a product of two lobes loses, in
// (-inf, 0]. lambda3 - lambda1 - lambda2, lambda3 the product's sharpness, from |v1 - v2|^2 in [0,
// 4] and without cancellation: -lambda1 lambda2 |v1 - v2|^2/(lambda1 + lambda2 + lambda3).
// Source: Xu et al. 2014; Meder and Bruederlin 2018, eq. 3
float sg_product_log_amplitude(float lambda1, float lambda2, float lambda3, float difference_squared)
{
    float total = lambda1 + lambda2 + lambda3;
    return -lambda1 * (lambda2 / (total > 0.0 ? total : 1.0)) * difference_squared;
}

// sg_product_sharpness: sharpness of the product of two lobes, |lambda1 v1 + lambda2 v2|, from |v1
// + v2|^2 in [0, 4]. No cancellation for opposite axes, no overflow below 1e38; 0 for opposite
// lobes of equal sharpness.
// Source: Xu et al. 2014; Meder and Bruederlin 2018, eq. 3
float sg_product_sharpness(float lambda1, float lambda2, float sum_squared)
{
    float total = lambda1 + lambda2;
    float divisor = total > 0.0 ? total : 1.0;
    float difference = (lambda1 - lambda2) / divisor;
    return total * sqrt(difference * difference + (lambda1 / divisor) * (lambda2 / divisor) * sum_squared);
}

// sg_tanh_half: tanh(x/2), with full relative precision next to 0.
float sg_tanh_half(float x)
{
    float q = sg_expm1(-abs(x));
    float t = q / (2.0 + q);
    return x < 0.0 ? t : -t;
}

// wang_2009: Cosine as a lobe, the common fit (published, 2009).
// sg_A_h_wang_2009 returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.171 at lambda 8859, beta 0.01257 (cos_theta 0.9999); RMSE 0.0491
//   double  max 0.17 at lambda 1e+04, beta 0 (cos_theta 1); RMSE 0.0491
// Cost on navi21: L 45 instructions, inverse throughput 35; A_h 15 instructions, inverse throughput
//   6
// Source: Wang et al., All-Frequency Rendering of Dynamic, Spatially-Varying Reflectance, 2009;
//   product and integral as Meder and Bruederlin, Screen Space Approximate Gaussian Hulls, 2018,
//   eqs 2 and 3
// Form lobe_product: the clamped cosine as one lobe about the normal; the product's integral, as
// published. The exponent cancels (in float all of it is lost by lambda = 1e8); opposite lobes of
// equal sharpness give 0/0.
float sg_A_h_wang_2009(float lambda, float cos_theta)
{
    const float sg_pi = 3.14159265358979;
    const float cosine_amplitude = 1.17;
    const float cosine_sharpness = 2.133;
    float sharpness = sqrt(lambda * lambda + cosine_sharpness * cosine_sharpness
        + 2.0 * lambda * cosine_sharpness * cos_theta);
    float amplitude = cosine_amplitude * exp(sharpness - lambda - cosine_sharpness);
    return amplitude * (2.0 * sg_pi) / sharpness * (1.0 - exp(-2.0 * sharpness));
}

// sg_L_wang_2009 returns L, in [0, 1] up to its error.
// Domain, error and source: above.
float sg_L_wang_2009(float lambda, float cos_theta)
{
    return sg_L_from_A_h(sg_A_h_wang_2009(lambda, cos_theta), lambda, cos_theta);
}

// wang_2009_stable: Cosine as a lobe, the common fit, stable (stable, 2009).
// sg_L_wang_2009_stable returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.135 at lambda 1e+04, beta 1.577 (cos_theta -0.006283); RMSE 0.0408
//   double  max 0.135 at lambda 1e+04, beta 1.577 (cos_theta -0.006283); RMSE 0.0408
// Cost on navi21: L 80 instructions, inverse throughput 85; A_h 105 instructions, inverse
//   throughput 116
// Source: Wang et al., All-Frequency Rendering of Dynamic, Spatially-Varying Reflectance, 2009;
//   product and integral as Meder and Bruederlin, Screen Space Approximate Gaussian Hulls, 2018,
//   eqs 2 and 3
// Form lobe_product_stable: the clamped cosine as one lobe about the normal; exponent and integrals
// without cancellation. Sharpnesses in units of their sum, so that no square overflows. Cut at 1,
// above which the model itself goes where cosine_amplitude is more than 1. It tends to
// cosine_amplitude e^(cosine_sharpness (z - 1)) as the sharpness grows; an infinite one gives what
// is right there, max(z, 0).
float sg_L_wang_2009_stable(float lambda, float cos_theta)
{
    const float cosine_amplitude = 1.17;
    const float cosine_sharpness = 2.133;
    float z = clamp(cos_theta, -1.0, 1.0);
    float sum = lambda + cosine_sharpness;
    float share = lambda / sum;
    float difference = (lambda - cosine_sharpness) / sum;
    float product = sqrt(difference * difference + 2.0 * share * (cosine_sharpness / sum) * (1.0 + z));
    float drop = 2.0 * cosine_sharpness * (1.0 - z);
    float area = sg_integral(sum * product) / sg_integral(lambda);
    float value = min(cosine_amplitude * exp(-drop * share / (1.0 + product)) * area, 1.0);
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : value;
}

// sg_A_h_wang_2009_stable returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_wang_2009_stable(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_wang_2009_stable(lambda, cos_theta), lambda);
}

// pettineo_hill_2016: Fitted irradiance of Pettineo and Hill (published, 2016).
// sg_A_h_pettineo_hill_2016 returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain: lambda in [1, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.0367 at lambda 1.274, beta 0 (cos_theta 1); RMSE 0.00528
//   double  max 0.0367 at lambda 1.274, beta 0 (cos_theta 1); RMSE 0.00528
// Cost on navi21: L 50 instructions, inverse throughput 45; A_h 22 instructions, inverse throughput
//   8
// Source: Pettineo and Hill, SG Series Part 3: Diffuse Lighting From an SG Light Source, 2016
// Form pettineo_hill: Pettineo's and Hill's fit of the irradiance, as published. For lambda >= 1
// only: below it diverges, is negative below 0.58 and is NaN where 1 - scale is not positive.
float sg_A_h_pettineo_hill_2016(float lambda, float cos_theta)
{
    const float sg_pi = 3.14159265358979;
    const float c0 = 0.36;
    float c1 = 1.0 / (4.0 * c0);
    float e = exp(-lambda);
    float e2 = e * e;
    float r = 1.0 / lambda;
    float scale = 1.0 + 2.0 * e2 - r;
    float bias = (e - e2) * r - e2;
    float x = sqrt(1.0 - scale);
    float x0 = c0 * cos_theta;
    float x1 = c1 * x;
    float n = x0 + x1;
    float y = abs(x0) <= x1 ? n * n / x : max(cos_theta, 0.0);
    return (scale * y + bias) * (2.0 * sg_pi) * r;
}

// sg_L_pettineo_hill_2016 returns L, in [0, 1] up to its error.
// Domain, error and source: above.
float sg_L_pettineo_hill_2016(float lambda, float cos_theta)
{
    return sg_L_from_A_h(sg_A_h_pettineo_hill_2016(lambda, cos_theta), lambda, cos_theta);
}

// pettineo_hill_2016_stable: Fitted irradiance of Pettineo and Hill, Hermite continuation below
//   lambda = 1 (stable, 2016).
// sg_L_pettineo_hill_2016_stable returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.0367 at lambda 1.274, beta 0 (cos_theta 1); RMSE 0.00455
//   double  max 0.0367 at lambda 1.274, beta 0 (cos_theta 1); RMSE 0.00455
// Cost on navi21: L 56 instructions, inverse throughput 75; A_h 82 instructions, inverse throughput
//   108
// Source: Pettineo and Hill, SG Series Part 3: Diffuse Lighting From an SG Light Source, 2016
// Form pettineo_hill_stable: Pettineo's and Hill's fit from lambda = 1 up, below it a Hermite
// continuation to the exact 1/4. 1 - scale is formed as 1/lambda - 2 e^-2lambda, which does not
// cancel. Below lambda = 1, where the fit diverges, the Hermite continuation: the cubic in lambda
// with the fit's own value and slope at 1 and, at 0, the integral's value 1/4 and slope z/6 (both
// exact).
float sg_L_pettineo_hill_2016_stable(float lambda, float cos_theta)
{
    const float c0 = 0.36;
    float z = clamp(cos_theta, -1.0, 1.0);
    float l = max(lambda, 1.0);
    float c1 = 1.0 / (4.0 * c0);
    float e = exp(-l);
    float e2 = e * e;
    float r = 1.0 / l;
    float rest = r - 2.0 * e2;
    float scale = 1.0 - rest;
    float bias = (e - e2) * r - e2;
    float area = 1.0 - e2;
    float x = sqrt(rest);
    float x0 = c0 * z;
    float x1 = c1 * x;
    float n = x0 + x1;
    bool inside = abs(x0) <= x1;
    float y = inside ? n * (n / x) : max(z, 0.0);
    float value = (scale * y + bias) / area;
    // the slope in lambda; used at l = 1 only, where every z is inside
    float scale_slope = r * r - 4.0 * e2;
    float bias_slope = (2.0 * e2 - e) * r - (e - e2) * r * r + 2.0 * e2;
    float y_slope = (n / x) * (n / x - 2.0 * c1) * scale_slope / (2.0 * x);
    float slope = (scale_slope * y + scale * y_slope + bias_slope - 2.0 * e2 * value) / area;
    float start = z * 0.166666666666666667;
    float rise = value - 0.25;
    float below = 0.25 + lambda * (start + lambda * (3.0 * rise - 2.0 * start - slope
        + lambda * (start + slope - 2.0 * rise)));
    float found = lambda < 1.0 ? below : value;
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : found;
}

// sg_A_h_pettineo_hill_2016_stable returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_pettineo_hill_2016_stable(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_pettineo_hill_2016_stable(lambda, cos_theta), lambda);
}

// tokuyoshi_2016: Cosine as a lobe of sharpness 2 (published, 2016).
// sg_A_h_tokuyoshi_2016 returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.154 at lambda 8508, beta 0.8482 (cos_theta 0.6613); RMSE 0.0537
//   double  max 0.153 at lambda 1e+04, beta 0.8577 (cos_theta 0.6542); RMSE 0.0537
// Cost on navi21: L 45 instructions, inverse throughput 35; A_h 15 instructions, inverse throughput
//   6
// Source: Tokuyoshi, Modified Filtered Importance Sampling for Virtual Spherical Gaussian Lights,
//   2016; Meder and Bruederlin, Screen Space Approximate Gaussian Hulls, 2018, eq. 8
// Form lobe_product: the clamped cosine as one lobe about the normal; the product's integral, as
// published. The exponent cancels (in float all of it is lost by lambda = 1e8); opposite lobes of
// equal sharpness give 0/0.
float sg_A_h_tokuyoshi_2016(float lambda, float cos_theta)
{
    const float sg_pi = 3.14159265358979;
    const float cosine_amplitude = 1.0;
    const float cosine_sharpness = 2.0;
    float sharpness = sqrt(lambda * lambda + cosine_sharpness * cosine_sharpness
        + 2.0 * lambda * cosine_sharpness * cos_theta);
    float amplitude = cosine_amplitude * exp(sharpness - lambda - cosine_sharpness);
    return amplitude * (2.0 * sg_pi) / sharpness * (1.0 - exp(-2.0 * sharpness));
}

// sg_L_tokuyoshi_2016 returns L, in [0, 1] up to its error.
// Domain, error and source: above.
float sg_L_tokuyoshi_2016(float lambda, float cos_theta)
{
    return sg_L_from_A_h(sg_A_h_tokuyoshi_2016(lambda, cos_theta), lambda, cos_theta);
}

// tokuyoshi_2016_stable: Cosine as a lobe of sharpness 2, stable (stable, 2016).
// sg_L_tokuyoshi_2016_stable returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.153 at lambda 1e+04, beta 0.8577 (cos_theta 0.6542); RMSE 0.0537
//   double  max 0.153 at lambda 1e+04, beta 0.8577 (cos_theta 0.6542); RMSE 0.0537
// Cost on navi21: L 79 instructions, inverse throughput 83; A_h 104 instructions, inverse
//   throughput 114
// Source: Tokuyoshi, Modified Filtered Importance Sampling for Virtual Spherical Gaussian Lights,
//   2016; Meder and Bruederlin, Screen Space Approximate Gaussian Hulls, 2018, eq. 8
// Form lobe_product_stable: the clamped cosine as one lobe about the normal; exponent and integrals
// without cancellation. Sharpnesses in units of their sum, so that no square overflows. Cut at 1,
// above which the model itself goes where cosine_amplitude is more than 1. It tends to
// cosine_amplitude e^(cosine_sharpness (z - 1)) as the sharpness grows; an infinite one gives what
// is right there, max(z, 0).
float sg_L_tokuyoshi_2016_stable(float lambda, float cos_theta)
{
    const float cosine_amplitude = 1.0;
    const float cosine_sharpness = 2.0;
    float z = clamp(cos_theta, -1.0, 1.0);
    float sum = lambda + cosine_sharpness;
    float share = lambda / sum;
    float difference = (lambda - cosine_sharpness) / sum;
    float product = sqrt(difference * difference + 2.0 * share * (cosine_sharpness / sum) * (1.0 + z));
    float drop = 2.0 * cosine_sharpness * (1.0 - z);
    float area = sg_integral(sum * product) / sg_integral(lambda);
    float value = min(cosine_amplitude * exp(-drop * share / (1.0 + product)) * area, 1.0);
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : value;
}

// sg_A_h_tokuyoshi_2016_stable returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_tokuyoshi_2016_stable(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_tokuyoshi_2016_stable(lambda, cos_theta), lambda);
}

// constant_cosine: Cosine constant over the lobe (published, 2018).
// sg_A_h_constant_cosine returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.75 at lambda 0.001, beta 0 (cos_theta 1); RMSE 0.256
//   double  max 0.75 at lambda 0.001, beta 0 (cos_theta 1); RMSE 0.256
// Cost on navi21: L 33 instructions, inverse throughput 14; A_h 8 instructions, inverse throughput
//   3
// Source: Meder and Bruederlin, Screen Space Approximate Gaussian Hulls, 2018, eqs 2 and 7
// Form constant_cosine: the cosine taken as constant over the lobe, as published: a directional
// light.
float sg_A_h_constant_cosine(float lambda, float cos_theta)
{
    const float sg_pi = 3.14159265358979;
    return max(cos_theta, 0.0) * (2.0 * sg_pi / lambda * (1.0 - exp(-2.0 * lambda)));
}

// sg_L_constant_cosine returns L, in [0, 1] up to its error.
// Domain, error and source: above.
float sg_L_constant_cosine(float lambda, float cos_theta)
{
    return sg_L_from_A_h(sg_A_h_constant_cosine(lambda, cos_theta), lambda, cos_theta);
}

// constant_cosine_stable: Cosine constant over the lobe, stable (stable, 2018).
// sg_L_constant_cosine_stable returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.75 at lambda 0.001, beta 0 (cos_theta 1); RMSE 0.256
//   double  max 0.75 at lambda 0.001, beta 0 (cos_theta 1); RMSE 0.256
// Cost on navi21: L 3 instructions, inverse throughput 1; A_h 29 instructions, inverse throughput 8
// Source: Meder and Bruederlin, Screen Space Approximate Gaussian Hulls, 2018, eqs 2 and 7
// Form constant_cosine_stable: the cosine taken as constant over the lobe; the lobe's integral has
// gone from L.
float sg_L_constant_cosine_stable(float lambda, float cos_theta)
{
    // the sharpness has no part in it, but a NaN there stays one
    return lambda == lambda ? clamp(cos_theta, 0.0, 1.0) : lambda;
}

// sg_A_h_constant_cosine_stable returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_constant_cosine_stable(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_constant_cosine_stable(lambda, cos_theta), lambda);
}

// meder_2018: Logistic between the poles (published, 2018).
// sg_A_h_meder_2018 returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   not finite, first at lambda 92.24, beta 0
//   double  max 0.00528 at lambda 2.336, beta 1.571 (cos_theta 0); RMSE 0.000798
// Cost on navi21: L 64 instructions, inverse throughput 74; A_h 38 instructions, inverse throughput
//   37
// Source: Meder and Bruederlin, Screen Space Approximate Gaussian Hulls, 2018, eqs 15 to 18
// Form meder_logistic: between the poles by clamped and normalised cosine, weighted by a logistic
// curve, as published. In float NaN from lambda = 88.7 on (e^lambda), and wrong by more than 1e-2
// below 2e-3 (A_u cancels).
float sg_A_h_meder_2018(float lambda, float cos_theta)
{
    const float t_scale = 2.1007;
    const float t_shift = 4.4653;
    const float u_slope = 0.2958;
    const float u_offset = 0.5033;
    float t = t_scale * sqrt(lambda) * lambda / (lambda + t_shift);
    float u = 1.0 / (u_slope * t + u_offset);
    float s = u / (exp(abs(cos_theta) * t) + 1.0);
    float c = s * (0.5 * cos_theta + 0.5) + (1.0 - s) * max(cos_theta, 0.0);
    return c * sg_A_u_printed(lambda) + (1.0 - c) * sg_A_b_printed(lambda);
}

// sg_L_meder_2018 returns L, in [0, 1] up to its error.
// Domain, error and source: above.
float sg_L_meder_2018(float lambda, float cos_theta)
{
    return sg_L_from_A_h(sg_A_h_meder_2018(lambda, cos_theta), lambda, cos_theta);
}

// meder_2018_hg: Hemispherical Gaussians, logistic (published, 2018).
// sg_A_h_meder_2018_hg returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.0348 at lambda 8508, beta 1.323 (cos_theta 0.2456); RMSE 0.00324
//   double  max 0.0111 at lambda 10, beta 1.122 (cos_theta 0.4343); RMSE 0.00297
// Cost on navi21: L 104 instructions, inverse throughput 149; A_h 75 instructions, inverse
//   throughput 109
// Source: Meder and Bruederlin, Hemispherical Gaussians for Accurate Light Integration, 2018; the
//   offset as public implementations carry it (Tokuyoshi's poster prints 31.703)
// Form hemisphere_logistic: the clamped cosine as a lobe less a constant, hemispheres by a logistic
// curve, as published. Two numbers of about 32 are subtracted and the exponent cancels: in float
// 0.03 is lost at lambda = 1e4. e^-t rounds to 1 below lambda = 1e-5: NaN there.
float sg_A_h_meder_2018_hg(float lambda, float cos_theta)
{
    const float cosine_amplitude = 32.708;
    const float cosine_sharpness = 0.0315;
    const float cosine_offset = 31.7003;
    const float t_cubic = 1.6988;
    const float t_square = 10.8438;
    const float t_linear = 6.2201;
    const float t_constant = 10.2415;
    float sharpness = sqrt(lambda * lambda + cosine_sharpness * cosine_sharpness
        + 2.0 * lambda * cosine_sharpness * cos_theta);
    float cosine = (lambda * cos_theta + cosine_sharpness) / sharpness;
    float t = sqrt(lambda) * (t_cubic * lambda * lambda + t_square * lambda)
        / (lambda * lambda + t_linear * lambda + t_constant);
    float t3 = sqrt(sharpness) * (t_cubic * sharpness * sharpness + t_square * sharpness)
        / (sharpness * sharpness + t_linear * sharpness + t_constant);
    return cosine_amplitude * exp(sharpness - lambda - cosine_sharpness) * sg_hemisphere_logistic(sharpness, cosine, t3)
        - cosine_offset * sg_hemisphere_logistic(lambda, cos_theta, t);
}

// sg_L_meder_2018_hg returns L, in [0, 1] up to its error.
// Domain, error and source: above.
float sg_L_meder_2018_hg(float lambda, float cos_theta)
{
    return sg_L_from_A_h(sg_A_h_meder_2018_hg(lambda, cos_theta), lambda, cos_theta);
}

// meder_2018_hg_stable: Hemispherical Gaussians, logistic, stable (stable, 2018).
// sg_L_meder_2018_hg_stable returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.0111 at lambda 10, beta 1.122 (cos_theta 0.4343); RMSE 0.00286
//   double  max 0.0111 at lambda 10, beta 1.122 (cos_theta 0.4343); RMSE 0.00286
// Cost on navi21: L 296 instructions, inverse throughput 518; A_h 316 instructions, inverse
//   throughput 546
// Source: Meder and Bruederlin, Hemispherical Gaussians for Accurate Light Integration, 2018; the
//   offset as public implementations carry it (Tokuyoshi's poster prints 31.703); cosine_scale =
//   32.708 e^-0.0315, cosine_rest = cosine_scale - 31.7003
// Form hemisphere_logistic_stable: the clamped cosine as a lobe less a constant, hemispheres by a
// logistic curve; the difference in closed form. As hemisphere_erf_stable, with R = tanh(t
// z/2)/tanh(t/2), which is 2s - 1 of the published logistic s, and with L = scale/2 (Q (1 + T3 R3)
// - (1 + T R)) + rest/2 (1 + T R), where scale = amplitude e^-c and rest = scale - offset are
// coefficients, because their difference cancels. Cut at 0 and 1: at grazing angles the model
// itself is negative, down to rest/2 at z = 0 and to rest just above it as the sharpness grows, and
// at z = 1 it goes up to 1.0077. An infinite sharpness gives max(z, 0), not the model's limit.
float sg_L_meder_2018_hg_stable(float lambda, float cos_theta)
{
    const float cosine_sharpness = 0.0315;
    const float cosine_scale = 31.693756203688917;
    const float cosine_rest = -0.0065437963110823475;
    const float t_cubic = 1.6988;
    const float t_square = 10.8438;
    const float t_linear = 6.2201;
    const float t_constant = 10.2415;
    float c = cosine_sharpness;
    float z = clamp(cos_theta, -1.0, 1.0);
    float sum = lambda + c;
    float difference = (lambda - c) / sum;
    float product = sum * sqrt(difference * difference + 2.0 * (lambda / sum) * (c / sum) * (1.0 + z));
    float d = (lambda * z + 0.5 * c) / (0.5 * product + 0.5 * lambda);
    float step = c * d;
    // steepness over sharpness, k, and bend = lambda (k3 - k)/step, in v = 1/(1 + lambda)
    float v = 1.0 / (1.0 + lambda);
    float v3 = 1.0 / (1.0 + product);
    float w = lambda * v;
    float w3 = product * v3;
    float root = sqrt(lambda);
    float root3 = sqrt(product);
    float below = w * w + v * (t_linear * w + t_constant * v);
    float below3 = w3 * w3 + v3 * (t_linear * w3 + t_constant * v3);
    float rate3 = v3 * (t_cubic * w3 + t_square * v3) / below3;
    float k = root * v * (t_cubic * w + t_square * v) / below;
    float k3 = root3 * rate3;
    float turn = (t_cubic * t_constant - t_square * t_linear) * v * v3 - t_square * (w * v3 + w3 * v) - t_cubic * w * w3;
    float bend = lambda * rate3 / (root3 + root) + root * w * v3 * turn / (below * below3);
    // tanh of half the steps of t z and of t, over c
    float tz_half = 0.5 * (k3 + z * d * bend);
    float t_half = 0.5 * d * (k3 + bend);
    float tz_square = (c * tz_half) * (c * tz_half) * 0.333333333333333333;
    float t_square_step = (c * t_half) * (c * t_half) * 0.333333333333333333;
    float tz_step = tz_half * (1.0 - tz_square * (1.0 - 1.2 * tz_square));
    float t_step = t_half * (1.0 - t_square_step * (1.0 - 1.2 * t_square_step));
    // at t = 0 R is z; next to it the quotient is that to 1e-9
    float t = max(k * lambda, 1.0e-4);
    float bent = sg_tanh_half(t * z);
    float full = sg_tanh_half(t);
    float ratio = bent / full;
    float full3 = sg_tanh_half(k3 * product);
    float tanh3 = sg_tanh_half(product);
    float tanh1 = sg_tanh_half(lambda);
    float rise = tz_step * (1.0 - bent * bent) / (1.0 + c * tz_step * bent)
        - ratio * t_step * (1.0 - full * full) / (1.0 + c * t_step * full);
    // (T3 R3 - T R)/c = (T3 - T) R/c + T3 (R3 - R)/c
    float half_square = step * step * 0.0833333333333333333;
    float tanh_step = 0.5 * d * (1.0 - half_square * (1.0 - 1.2 * half_square)) * (1.0 - tanh1 * tanh3);
    float stepped = tanh_step * ratio + tanh3 / full3 * rise;
    // where the product's sharpness can vanish both terms are as small as c, and their difference loses nothing
    float ratio3 = full3 > 0.0 ? sg_tanh_half(k3 * ((c - lambda) + lambda * (1.0 + z))) / full3 : 0.0;
    float direct = (tanh3 * ratio3 - tanh1 * ratio) / c;
    float bias_step = lambda < 4.0 * c ? direct : stepped;
    float bias = tanh1 * ratio;
    float gain = d * sg_gain_step(lambda, product, step) * (1.0 + bias + c * bias_step) + bias_step;
    float value = 0.5 * (cosine_scale * c * gain + cosine_rest * (1.0 + bias));
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : clamp(value, 0.0, 1.0);
}

// sg_A_h_meder_2018_hg_stable returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_meder_2018_hg_stable(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_meder_2018_hg_stable(lambda, cos_theta), lambda);
}

// meder_2018_stable: Logistic between the poles, stable (stable, 2018).
// sg_L_meder_2018_stable returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00528 at lambda 2.336, beta 1.571 (cos_theta 0); RMSE 0.000798
//   double  max 0.00528 at lambda 2.336, beta 1.571 (cos_theta 0); RMSE 0.000798
// Cost on navi21: L 75 instructions, inverse throughput 91; A_h 97 instructions, inverse throughput
//   120
// Source: Meder and Bruederlin, Screen Space Approximate Gaussian Hulls, 2018, eqs 15 to 18
// Form meder_logistic_stable: between the poles by clamped and normalised cosine, weighted by a
// logistic curve; L from the start. The poles are A_b/A = sg_L_b and A_u/A = sg_L_b + sg_mean, and
// the weight of the poles is max(z, 0) + s (1 - |z|)/2: a sum of terms that are not negative, so
// that nothing cancels and no exponential grows.
float sg_L_meder_2018_stable(float lambda, float cos_theta)
{
    const float t_scale = 2.1007;
    const float t_shift = 4.4653;
    const float u_slope = 0.2958;
    const float u_offset = 0.5033;
    float z = clamp(cos_theta, -1.0, 1.0);
    float size = abs(z);
    float t = t_scale * sqrt(lambda) * (1.0 - t_shift / (lambda + t_shift));
    float u = 1.0 / (u_slope * t + u_offset);
    float e = exp(-t * size);
    float c = max(z, 0.0) + 0.5 * u * e / (1.0 + e) * (1.0 - size);
    float value = sg_L_b(lambda) + sg_mean(lambda) * c;
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : value;
}

// sg_A_h_meder_2018_stable returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_meder_2018_stable(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_meder_2018_stable(lambda, cos_theta), lambda);
}

// tokuyoshi_2022: Hemispherical Gaussians, error function (published, 2022).
// sg_L_tokuyoshi_2022 returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00393 at lambda 5.915, beta 0.9142 (cos_theta 0.6104); RMSE 0.00056
//   double  max 0.00369 at lambda 5.915, beta 0.9519 (cos_theta 0.5801); RMSE 0.000557
// Cost on navi21: L 298 instructions, inverse throughput 419; A_h 322 instructions, inverse
//   throughput 449
// Source: Tokuyoshi, Accurate Diffuse Lighting from Spherical Gaussian Lights, 2022, eq. 1 and
//   section 2
// Form hemisphere_erf: the clamped cosine as a lobe less a constant, hemispheres by an error
// function, as published. L = alpha (p - q), p and q hemispheres of the product and of the lobe
// over A, cut at 0. The product's exponent and the integrals are written without cancellation, as
// the poster's results were computed; what float still loses is the rounding of p and q, enlarged
// by alpha, which is 1182. p and q lie within a factor of 2 of each other, so that p - q is exact
// and Kahan's difference of alpha p and alpha q could not do better.
float sg_L_tokuyoshi_2022(float lambda, float cos_theta)
{
    const float cosine_sharpness = 8.456087224148012e-4;
    const float alpha = 1182.246733967815;
    const float t_0 = 0.6517328826907056;
    const float t_1 = 1.3418280033141288;
    const float t_2 = 7.221668779895671;
    float sharpness = sqrt(lambda * lambda + cosine_sharpness * cosine_sharpness
        + 2.0 * lambda * cosine_sharpness * cos_theta);
    float cosine = (lambda * cos_theta + cosine_sharpness) / sharpness;
    float t = lambda * sqrt((0.5 * lambda + t_0) / (lambda * lambda + t_1 * lambda + t_2));
    float t3 = sharpness * sqrt((0.5 * sharpness + t_0) / (sharpness * sharpness + t_1 * sharpness + t_2));
    // e^lambda_c times the product's amplitude is e^(sharpness - lambda)
    float exponent = cosine_sharpness * (2.0 * lambda * cos_theta + cosine_sharpness) / (sharpness + lambda);
    float p = exp(exponent) * sg_integral(sharpness) / sg_integral(lambda) * sg_hemisphere_erf(sharpness, cosine, t3);
    float q = sg_hemisphere_erf(lambda, cos_theta, t);
    return max(alpha * (p - q), 0.0);
}

// sg_A_h_tokuyoshi_2022 returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_tokuyoshi_2022(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_tokuyoshi_2022(lambda, cos_theta), lambda);
}

// tokuyoshi_2022_stable: Hemispherical Gaussians, error function, stable (stable, 2022).
// sg_L_tokuyoshi_2022_stable returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00369 at lambda 5.915, beta 0.955 (cos_theta 0.5776); RMSE 0.000557
//   double  max 0.00369 at lambda 5.915, beta 0.9519 (cos_theta 0.5801); RMSE 0.000557
// Cost on navi21: L 363 instructions, inverse throughput 603; A_h 384 instructions, inverse
//   throughput 631
// Source: Tokuyoshi, Accurate Diffuse Lighting from Spherical Gaussian Lights, 2022, eq. 1 and
//   section 2
// Form hemisphere_erf_stable: the clamped cosine as a lobe less a constant, hemispheres by an error
// function; the difference in closed form. With c the cosine's sharpness, the hemisphere of a lobe
// is A/2 (1 + T R), T = tanh(lambda/2), R = erf(t z)/erf(t), and L = alpha/2 (Q (1 + T3 R3) - (1 +
// T R)), where 3 marks the product and Q = A3 e^sharpness3 / (A e^lambda). alpha c is about 1: each
// of Q - 1, T3 - T, t3 - t ... is formed divided by c, from sharpness3 - lambda = c (2 lambda z +
// c)/(sharpness3 + lambda), so that nothing of the difference is lost. Cut at 0 and 1, which the
// model itself passes, to -5.1e-4 at (9.1, z = -0.81) and to 1.00014 at z = 1 for large
// sharpnesses.
float sg_L_tokuyoshi_2022_stable(float lambda, float cos_theta)
{
    const float cosine_sharpness = 8.456087224148012e-4;
    const float alpha = 1182.246733967815;
    const float t_0 = 0.6517328826907056;
    const float t_1 = 1.3418280033141288;
    const float t_2 = 7.221668779895671;
    float c = cosine_sharpness;
    float z = clamp(cos_theta, -1.0, 1.0);
    float sum = lambda + c;
    float difference = (lambda - c) / sum;
    float product = sum * sqrt(difference * difference + 2.0 * (lambda / sum) * (c / sum) * (1.0 + z));
    float d = (lambda * z + 0.5 * c) / (0.5 * product + 0.5 * lambda);
    float step = c * d;
    // steepness over sharpness, k, and bend = lambda (k3 - k)/step, in v = 1/(1 + lambda)
    float v = 1.0 / (1.0 + lambda);
    float v3 = 1.0 / (1.0 + product);
    float w = lambda * v;
    float w3 = product * v3;
    float below = w * w + v * (t_1 * w + t_2 * v);
    float below3 = w3 * w3 + v3 * (t_1 * w3 + t_2 * v3);
    float k = sqrt(v * (0.5 * w + t_0 * v) / below);
    float k3 = sqrt(v3 * (0.5 * w3 + t_0 * v3) / below3);
    float turn = (0.5 * t_2 - t_0 * t_1) * v * v3 - t_0 * (w * v3 + w3 * v) - 0.5 * w * w3;
    float bend = w * v3 * turn / (below * below3 * (k3 + k));
    // steps of t z and of t, over c
    float tz_step = k3 + z * d * bend;
    float t_step = d * (k3 + bend);
    // at t = 0 R is z; next to it the quotient is that to 1e-9
    float t = max(k * lambda, 1.0e-4);
    float ratio = sg_erf(t * z) / sg_erf(t);
    float small = max(product, 1.0e-4);
    float tanh3 = sg_tanh_half(product);
    float tanh1 = sg_tanh_half(lambda);
    float rise = tz_step * sg_erf_step(k * lambda * z + 0.5 * c * tz_step, c * tz_step)
        - ratio * t_step * sg_erf_step(k * lambda + 0.5 * c * t_step, c * t_step);
    // (T3 R3 - T R)/c = (T3 - T) R/c + T3 (R3 - R)/c
    float tanh_step = 0.5 * d * (1.0 - step * step * 0.0833333333333333333) * (1.0 - tanh1 * tanh3);
    float bias_step = tanh_step * ratio + sg_tanh_half(small) / sg_erf(k3 * small) * rise;
    float bias3 = tanh1 * ratio + c * bias_step;
    float value = 0.5 * alpha * c * (d * sg_gain_step(lambda, product, step) * (1.0 + bias3) + bias_step);
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : clamp(value, 0.0, 1.0);
}

// sg_A_h_tokuyoshi_2022_stable returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_tokuyoshi_2022_stable(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_tokuyoshi_2022_stable(lambda, cos_theta), lambda);
}

// tokuyoshi_2024: Planar Gaussian between the poles (published, 2024).
// sg_A_h_tokuyoshi_2024 returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00128 at lambda 5.915, beta 2.259 (cos_theta -0.635); RMSE 0.000194
//   double  max 0.00128 at lambda 5.915, beta 2.259 (cos_theta -0.635); RMSE 0.000194
// Cost on navi21: L 245 instructions, inverse throughput 342; A_h 219 instructions, inverse
//   throughput 307
// Source: Tokuyoshi et al., Hierarchical Light Sampling with Accurate Spherical Gaussian Lighting,
//   2024, supplement
// Form cosine_erf: between the poles by the integral of a planar Gaussian times a clamped plane, as
// published. 0/0 at lambda = 0. A_u and A_b are taken without cancellation; in float nothing else
// is lost.
float sg_A_h_tokuyoshi_2024(float lambda, float cos_theta)
{
    const float sg_pi = 3.14159265358979;
    const float t_a = 2.736083161127256;
    const float t_b = 17.021297781741875;
    const float t_c = 4.010082672851042;
    const float t_d = 15.21915626314721;
    const float t_e = 76.08789627236074;
    float t = lambda * sqrt(0.5 * (lambda * lambda + t_a * lambda + t_b)
        / (lambda * lambda * lambda + t_c * lambda * lambda + t_d * lambda + t_e));
    float s = 0.5 * (cos_theta * sg_erfc(-t * cos_theta) + sg_erfc(t))
        - exp(-t * t * cos_theta * cos_theta) * sg_expm1(t * t * (cos_theta * cos_theta - 1.0))
        / (2.0 * t * sqrt(sg_pi));
    float lower = sg_A_b(lambda);
    return lower + s * (sg_A_u(lambda) - lower);
}

// sg_L_tokuyoshi_2024 returns L, in [0, 1] up to its error.
// Domain, error and source: above.
float sg_L_tokuyoshi_2024(float lambda, float cos_theta)
{
    return sg_L_from_A_h(sg_A_h_tokuyoshi_2024(lambda, cos_theta), lambda, cos_theta);
}

// tokuyoshi_2024_stable: Planar Gaussian between the poles, stable (stable, 2024).
// sg_L_tokuyoshi_2024_stable returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00128 at lambda 5.915, beta 2.259 (cos_theta -0.635); RMSE 0.000194
//   double  max 0.00128 at lambda 5.915, beta 2.259 (cos_theta -0.635); RMSE 0.000194
// Cost on navi21: L 180 instructions, inverse throughput 259; A_h 202 instructions, inverse
//   throughput 288
// Source: Tokuyoshi et al., Hierarchical Light Sampling with Accurate Spherical Gaussian Lighting,
//   2024, supplement
// Form cosine_erf_stable: between the poles by the integral of a planar Gaussian times a clamped
// plane; L from the start. The steepness is written in v = 1/(1 + lambda), so that no power of
// lambda overflows, and expm1(y)/t as t expm1(y)/t^2, which is not 0/0 at lambda = 0.
float sg_L_tokuyoshi_2024_stable(float lambda, float cos_theta)
{
    const float t_a = 2.736083161127256;
    const float t_b = 17.021297781741875;
    const float t_c = 4.010082672851042;
    const float t_d = 15.21915626314721;
    const float t_e = 76.08789627236074;
    float z = clamp(cos_theta, -1.0, 1.0);
    float v = 1.0 / (1.0 + lambda);
    float w = 1.0 - v;
    float above = w * w + v * (t_a * w + t_b * v);
    float below = w * w * w + v * (t_c * w * w + v * (t_d * w + t_e * v));
    float t = lambda * sqrt(0.5 * v * above / below);
    float side = (1.0 - z) * (1.0 + z);
    float bell = exp(-(t * z) * (t * z)) * side * t * sg_one_minus_exp_over(t * t * side);
    // 1/(2 sqrt(pi))
    float s = 0.5 * (z * sg_erfc(-t * z) + sg_erfc(t)) + 0.282094791773878143 * bell;
    float value = max(sg_L_b(lambda) + sg_mean(lambda) * s, 0.0);
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : value;
}

// sg_A_h_tokuyoshi_2024_stable returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_tokuyoshi_2024_stable(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_tokuyoshi_2024_stable(lambda, cos_theta), lambda);
}

// brisk: Root over a Gaussian bell, one term (tier, 2026).
// sg_L_brisk returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00048 at lambda 2.154, beta 0.7917 (cos_theta 0.7026); RMSE 0.00024
//   double  max 0.00048 at lambda 2.154, beta 0.7885 (cos_theta 0.7049); RMSE 0.00024
// Cost on navi21: L 21 instructions, inverse throughput 7; A_h 47 instructions, inverse throughput
//   38
// Source: sgfit fit brisk (fit/recipes/brisk.json)
// Made by: sgfit fit brisk
// Form root_bell_1: half the odd part and a root, over a Gaussian bell with one term. With p = z m
// / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and t = T (T + 2 |p|), T =
// L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even analytic function of
// lambda and of z: no crease at the terminator, and one polynomial in s = 1/sqrt(lambda^2 + ...)
// serves from lambda = 0 to infinity. g = s (lambda z)^2; the bell t = s (polynomial in g, its
// coefficients polynomials in s) 2^(-k g). lambda is held where its square is a float; the literal
// coefficients are such as a GPU has for free.
float sg_L_brisk(float lambda, float cos_theta)
{
    const float b = 8.661933449032052;
    const float m1 = -0.5039835787380085;
    const float m2 = 2.068290496776696;
    const float e0 = 0.15620046990811134;
    const float e1 = -0.08688166435638058;
    const float k0 = 0.7306885201624123;
    const float a0 = -0.1600776113667497;
    float l = min(lambda, 1e18);
    float s = inversesqrt(l * l + b);
    float a = l * cos_theta;
    float q = a * s;
    float p = q * (0.5 + s * (m1 + s * (m2 - s * 2.0)));
    float g = a * q;
    float t = e0 + s * ((e1 + s * 0.5) + g * a0);
    float u = exp2((s - k0) * g);
    return clamp(p + sqrt(p * p + t * (s * u)), 0.0, 1.0);
}

// sg_A_h_brisk returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_brisk(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_brisk(lambda, cos_theta), lambda);
}

// fine: Root over a Gaussian bell, five terms (tier, 2026).
// sg_L_fine returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 5.77e-07 at lambda 16.24, beta 0.8011 (cos_theta 0.6959); RMSE 1.89e-07
//   double  max 4.49e-07 at lambda 3.643, beta 0 (cos_theta 1); RMSE 1.86e-07
// Cost on navi21: L 68 instructions, inverse throughput 83; A_h 94 instructions, inverse throughput
//   116
// Source: sgfit fit fine (fit/recipes/fine.json)
// Made by: sgfit fit fine
// Form root_bell_5: half the odd part and a root, over a Gaussian bell with five terms. With p = z
// m / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and t = T (T + 2 |p|), T
// = L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even analytic function
// of lambda and of z: no crease at the terminator, and one polynomial in s = 1/sqrt(lambda^2 + ...)
// serves from lambda = 0 to infinity. g = s (lambda z)^2; the bell t = s (polynomial in g, its
// coefficients polynomials in s) 2^(-k g). The inner quotient moves the poles of m, at lambda = i
// pi, out of the way. lambda is held where its square is a float, g where its powers are; exp2 has
// vanished long before.
float sg_L_fine(float lambda, float cos_theta)
{
    const float b = 9.770485390644541;
    const float b1 = 34.358799052107955;
    const float b2 = 31.819805628532155;
    const float m1 = -0.49993502761884645;
    const float m2 = 2.435768513476101;
    const float m3 = -4.661025276565961;
    const float m4 = 23.651728487627587;
    const float m5 = -55.541631438923424;
    const float m6 = 50.807418711237105;
    const float e0 = 0.15916265244726366;
    const float e1 = -0.1201535354882521;
    const float e2 = 0.7840335535755301;
    const float e3 = -1.3894647861626075;
    const float e4 = 8.616322971545529;
    const float e5 = -15.129412128621235;
    const float e6 = 14.455777978492431;
    const float k0 = 0.7104660909445603;
    const float k1 = -1.2026015574683218;
    const float k2 = -2.690870894451964;
    const float k3 = -14.916457799512573;
    const float k4 = 86.213457501491;
    const float k5 = -82.28140032464508;
    const float k6 = -13.276523029288867;
    const float a0 = -0.012463829129697552;
    const float a1 = -0.04953877065552029;
    const float a2 = -0.7452388864240758;
    const float a3 = -0.3362365318708385;
    const float a4 = 0.5874926412414468;
    const float c0 = 0.0010457363139175317;
    const float c1 = -0.017957828779423837;
    const float c2 = 0.08189440779051237;
    const float c3 = 0.16663309738890864;
    const float c4 = 1.90923232839575;
    const float c5 = -5.041394724810701;
    const float d0 = -6.546661601587844e-5;
    const float d1 = 8.370786869801877e-4;
    const float d2 = 2.5866043013189925e-4;
    const float d3 = 0.08119267023737292;
    const float d4 = -0.6439083952260073;
    const float d5 = 1.026094686392264;
    const float f0 = 1.1038487174341621e-6;
    const float f1 = 4.6445678114377605e-5;
    const float f2 = -1.8598538685655713e-4;
    const float f3 = -2.1688162767113296e-4;
    const float j0 = 6.101325592663997e-8;
    const float j1 = -3.4595099085301664e-6;
    const float j2 = 2.985942038361842e-6;
    float l = min(lambda, 1e18);
    float h = l * l + b;
    float s = inversesqrt(h + b1 / (h + b2));
    float a = l * cos_theta;
    float q = a * s;
    float p = q * (0.5 + s * (m1 + s * (m2 + s * (m3 + s * (m4 + s * (m5 + s * m6))))));
    float g = min(a * q, 1e3);
    float k = k0 + s * (k1 + s * (k2 + s * (k3 + s * (k4 + s * (k5 + s * k6)))));
    float t = j0 + s * (j1 + s * j2);
    t = (f0 + s * (f1 + s * (f2 + s * f3))) + g * t;
    t = (d0 + s * (d1 + s * (d2 + s * (d3 + s * (d4 + s * d5))))) + g * t;
    t = (c0 + s * (c1 + s * (c2 + s * (c3 + s * (c4 + s * c5))))) + g * t;
    t = (a0 + s * (a1 + s * (a2 + s * (a3 + s * a4)))) + g * t;
    t = (e0 + s * (e1 + s * (e2 + s * (e3 + s * (e4 + s * (e5 + s * e6)))))) + g * t;
    return clamp(p + sqrt(p * p + t * (s * exp2(-k * g))), 0.0, 1.0);
}

// sg_A_h_fine returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_fine(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_fine(lambda, cos_theta), lambda);
}

// logistic_minimax: Logistic with the exact limits, minimax (refit, 2026).
// sg_L_logistic_minimax returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.000661 at lambda 17.6, beta 1.605 (cos_theta -0.03455); RMSE 0.000136
//   double  max 0.000661 at lambda 17.6, beta 1.536 (cos_theta 0.03455); RMSE 0.000136
// Cost on navi21: L 86 instructions, inverse throughput 109; A_h 108 instructions, inverse
//   throughput 138
// Source: sgfit fit logistic_minimax (fit/recipes/logistic_minimax.json)
// Made by: sgfit fit logistic_minimax
// Form logistic_limits: Meder's logistic weight with a t and a u that have the exact limits at
// lambda = 0 and infinity. t -> 3/8 lambda and u -> 2 - 3/8 lambda at 0, t -> t_infinity
// sqrt(lambda) and u -> u_infinity/sqrt(lambda) at infinity. t is a rational function of v = 1/(1 +
// lambda), in which nothing overflows, and 1/u - 1/2 one of t. L is written as m max(z, 0) plus the
// rest, so that L(z) - L(-z) = z m holds exactly.
float sg_L_logistic_minimax(float lambda, float cos_theta)
{
    const float t_infinity = 2.1583;
    const float u_infinity = 1.569;
    const float p_1 = 1.7325081690486936;
    const float q_1 = 7.073468683731582;
    const float q_2 = -14.346702658982363;
    const float q_3 = 256.684937818807;
    const float u_1 = 0.06558361445813207;
    float z = clamp(cos_theta, -1.0, 1.0);
    float size = abs(z);
    float v = 1.0 / (1.0 + lambda);
    float p_0 = t_infinity * t_infinity;
    float p_2 = 0.140625 * (1.0 + q_1 + q_2 + q_3) - p_0 - p_1;
    float t = lambda * sqrt(v * (p_0 + v * (p_1 + v * p_2))
        / (1.0 + v * (q_1 + v * (q_2 + v * q_3))));
    float slope = u_1 / (u_infinity * t_infinity);
    float u = (1.0 + u_1 * t) / (0.5 + t * (0.25 + 0.5 * u_1 + slope * t));
    float e = exp(-t * size);
    float c = max(z, 0.0) + 0.5 * u * e / (1.0 + e) * (1.0 - size);
    float value = sg_L_b(lambda) + sg_mean(lambda) * c;
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : value;
}

// sg_A_h_logistic_minimax returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_logistic_minimax(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_logistic_minimax(lambda, cos_theta), lambda);
}

// logistic_refit: Logistic with the exact limits, least squares (refit, 2026).
// sg_L_logistic_refit returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.000733 at lambda 9.604, beta 0.8954 (cos_theta 0.6252); RMSE 0.000115
//   double  max 0.000733 at lambda 9.604, beta 0.8954 (cos_theta 0.6252); RMSE 0.000115
// Cost on navi21: L 86 instructions, inverse throughput 109; A_h 108 instructions, inverse
//   throughput 138
// Source: sgfit fit logistic_refit (fit/recipes/logistic_refit.json)
// Made by: sgfit fit logistic_refit
// Form logistic_limits: Meder's logistic weight with a t and a u that have the exact limits at
// lambda = 0 and infinity. t -> 3/8 lambda and u -> 2 - 3/8 lambda at 0, t -> t_infinity
// sqrt(lambda) and u -> u_infinity/sqrt(lambda) at infinity. t is a rational function of v = 1/(1 +
// lambda), in which nothing overflows, and 1/u - 1/2 one of t. L is written as m max(z, 0) plus the
// rest, so that L(z) - L(-z) = z m holds exactly.
float sg_L_logistic_refit(float lambda, float cos_theta)
{
    const float t_infinity = 2.1583;
    const float u_infinity = 1.569;
    const float p_1 = 13.67232647680608;
    const float q_1 = 11.472170013069078;
    const float q_2 = -27.463913820113483;
    const float q_3 = 469.67739399817657;
    const float u_1 = 0.0995731966289656;
    float z = clamp(cos_theta, -1.0, 1.0);
    float size = abs(z);
    float v = 1.0 / (1.0 + lambda);
    float p_0 = t_infinity * t_infinity;
    float p_2 = 0.140625 * (1.0 + q_1 + q_2 + q_3) - p_0 - p_1;
    float t = lambda * sqrt(v * (p_0 + v * (p_1 + v * p_2))
        / (1.0 + v * (q_1 + v * (q_2 + v * q_3))));
    float slope = u_1 / (u_infinity * t_infinity);
    float u = (1.0 + u_1 * t) / (0.5 + t * (0.25 + 0.5 * u_1 + slope * t));
    float e = exp(-t * size);
    float c = max(z, 0.0) + 0.5 * u * e / (1.0 + e) * (1.0 - size);
    float value = sg_L_b(lambda) + sg_mean(lambda) * c;
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : value;
}

// sg_A_h_logistic_refit returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_logistic_refit(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_logistic_refit(lambda, cos_theta), lambda);
}

// meder_2018_minimax: Logistic between the poles, minimax (refit, 2026).
// sg_L_meder_2018_minimax returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00231 at lambda 37.93, beta 1.455 (cos_theta 0.116); RMSE 0.000521
//   double  max 0.00231 at lambda 37.93, beta 1.687 (cos_theta -0.116); RMSE 0.000521
// Cost on navi21: L 75 instructions, inverse throughput 91; A_h 97 instructions, inverse throughput
//   120
// Source: sgfit fit meder_2018_minimax (fit/recipes/meder_2018_minimax.json)
// Made by: sgfit fit meder_2018_minimax
// Form meder_logistic_stable: between the poles by clamped and normalised cosine, weighted by a
// logistic curve; L from the start. The poles are A_b/A = sg_L_b and A_u/A = sg_L_b + sg_mean, and
// the weight of the poles is max(z, 0) + s (1 - |z|)/2: a sum of terms that are not negative, so
// that nothing cancels and no exponential grows.
float sg_L_meder_2018_minimax(float lambda, float cos_theta)
{
    const float t_scale = 2.314342453517853;
    const float t_shift = 4.469632694403361;
    const float u_slope = 0.26727533369808754;
    const float u_offset = 0.4913529321656519;
    float z = clamp(cos_theta, -1.0, 1.0);
    float size = abs(z);
    float t = t_scale * sqrt(lambda) * (1.0 - t_shift / (lambda + t_shift));
    float u = 1.0 / (u_slope * t + u_offset);
    float e = exp(-t * size);
    float c = max(z, 0.0) + 0.5 * u * e / (1.0 + e) * (1.0 - size);
    float value = sg_L_b(lambda) + sg_mean(lambda) * c;
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : value;
}

// sg_A_h_meder_2018_minimax returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_meder_2018_minimax(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_meder_2018_minimax(lambda, cos_theta), lambda);
}

// meder_2018_refit: Logistic between the poles, least squares (refit, 2026).
// sg_L_meder_2018_refit returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00291 at lambda 6.677, beta 1.508 (cos_theta 0.06279); RMSE 0.00047
//   double  max 0.00291 at lambda 6.677, beta 1.508 (cos_theta 0.06279); RMSE 0.00047
// Cost on navi21: L 75 instructions, inverse throughput 91; A_h 97 instructions, inverse throughput
//   120
// Source: sgfit fit meder_2018_refit (fit/recipes/meder_2018_refit.json)
// Made by: sgfit fit meder_2018_refit
// Form meder_logistic_stable: between the poles by clamped and normalised cosine, weighted by a
// logistic curve; L from the start. The poles are A_b/A = sg_L_b and A_u/A = sg_L_b + sg_mean, and
// the weight of the poles is max(z, 0) + s (1 - |z|)/2: a sum of terms that are not negative, so
// that nothing cancels and no exponential grows.
float sg_L_meder_2018_refit(float lambda, float cos_theta)
{
    const float t_scale = 2.36124341612423;
    const float t_shift = 4.616744025855256;
    const float u_slope = 0.2598843229363824;
    const float u_offset = 0.5021997383659007;
    float z = clamp(cos_theta, -1.0, 1.0);
    float size = abs(z);
    float t = t_scale * sqrt(lambda) * (1.0 - t_shift / (lambda + t_shift));
    float u = 1.0 / (u_slope * t + u_offset);
    float e = exp(-t * size);
    float c = max(z, 0.0) + 0.5 * u * e / (1.0 + e) * (1.0 - size);
    float value = sg_L_b(lambda) + sg_mean(lambda) * c;
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : value;
}

// sg_A_h_meder_2018_refit returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_meder_2018_refit(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_meder_2018_refit(lambda, cos_theta), lambda);
}

// medium: Root over a Gaussian bell, two terms (tier, 2026).
// sg_L_medium returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 9.83e-05 at lambda 1.833, beta 3.142 (cos_theta -1); RMSE 3.09e-05
//   double  max 9.83e-05 at lambda 1.833, beta 3.142 (cos_theta -1); RMSE 3.09e-05
// Cost on navi21: L 27 instructions, inverse throughput 9; A_h 53 instructions, inverse throughput
//   42
// Source: sgfit fit medium (fit/recipes/medium.json)
// Made by: sgfit fit medium
// Form root_bell_2: half the odd part and a root, over a Gaussian bell with two terms. With p = z m
// / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and t = T (T + 2 |p|), T =
// L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even analytic function of
// lambda and of z: no crease at the terminator, and one polynomial in s = 1/sqrt(lambda^2 + ...)
// serves from lambda = 0 to infinity. g = s (lambda z)^2; the bell t = s (polynomial in g, its
// coefficients polynomials in s) 2^(-k g). lambda is held where its square is a float.
float sg_L_medium(float lambda, float cos_theta)
{
    const float b = 6.739169803466794;
    const float m1 = -0.4977000112012122;
    const float m2 = 1.5865003161602866;
    const float m3 = -1.9546892062992305;
    const float e0 = 0.15873170876230316;
    const float e1 = -0.11914490702119242;
    const float e2 = 0.5438024261940932;
    const float e3 = -0.5471213836964591;
    const float k0 = 0.7969493025641795;
    const float k1 = -1.2906990865615058;
    const float a0 = -0.12278844353640792;
    const float b0 = -0.006265904324199117;
    float l = min(lambda, 1e18);
    float s = inversesqrt(l * l + b);
    float a = l * cos_theta;
    float q = a * s;
    float p = q * (0.5 + s * (m1 + s * (m2 + s * m3)));
    float g = a * q;
    float t = e0 + s * ((e1 + s * (e2 + s * e3)) + g * (a0 + g * b0));
    float u = exp2(-(k0 + s * k1) * g);
    return clamp(p + sqrt(p * p + t * (s * u)), 0.0, 1.0);
}

// sg_A_h_medium returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_medium(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_medium(lambda, cos_theta), lambda);
}

// positive: Root with a true tail (tier, 2026).
// sg_L_positive returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.000503 at lambda 4.112, beta 0.003142 (cos_theta 1); RMSE 0.00023
//   double  max 0.000503 at lambda 4.112, beta 0 (cos_theta 1); RMSE 0.00023
// Cost on navi21: L 50 instructions, inverse throughput 51; A_h 76 instructions, inverse throughput
//   84
// Source: sgfit fit positive (fit/recipes/positive.json)
// Made by: sgfit fit positive
// Form root_tail: half the odd part and a root, the far tail kept in proportion. With p = z m / 2
// (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and t = T (T + 2 |p|), T =
// L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even analytic function of
// lambda and of z: no crease at the terminator, and one polynomial in s = 1/sqrt(lambda^2 + ...)
// serves from lambda = 0 to infinity. At the back L = t / (|p| + root), which does not cancel. The
// bell follows the lobe instead of its Gaussian: w = sqrt(lambda^2 + b) - sqrt(lambda^2 (1 - z^2) +
// b), and t = s (polynomial in s) 2^(-k w) / sqrt(d), d a polynomial in w and s. t is carried 2^40
// times too large, since it is the square of a tail that may itself be as small as a float can be;
// lambda is held where its square is a float.
float sg_L_positive(float lambda, float cos_theta)
{
    const float b = 2.901688061851163;
    const float m1 = -0.4939413789200897;
    const float m2 = 0.6967078509727059;
    const float m3 = -1.5742484790924904;
    const float m4 = 1.2895707237198983;
    const float e0 = 0.15825996260925232;
    const float e1 = -0.08059510246818169;
    const float e2 = -0.012264699073911738;
    const float k0 = 1.443307759164753;
    const float a0 = 0.3008079277016142;
    const float a1 = -1.7131507255362137;
    const float a2 = -9.755545001385052e-4;
    const float c0 = -0.4679655600613682;
    const float c1 = 2.341289432531464;
    const float c2 = -3.0733189385069952;
    const float d0 = 0.1660344572406734;
    const float d1 = -1.0446556734121901;
    float l = min(lambda, 1e18);
    float h = l * l + b;
    float s = inversesqrt(h);
    float a = l * cos_theta;
    float p = (a * s) * (0.5 + s * (m1 + s * (m2 + s * (m3 + s * m4))));
    float w = a * (a / (h * s + sqrt(max(h - a * a, b))));
    float y = w * s;
    float d = (c0 + s * (c1 + s * c2)) + y * (d0 + s * d1);
    d = 1.0 + w * ((a0 + s * (a1 + s * a2)) + y * d);
    float u = exp2(40.0 - k0 * w) * inversesqrt(max(d, 0.1));
    float t = (e0 + s * (e1 + s * e2)) * (s * u);
    float r = abs(p) + sqrt(p * p + t * 9.094947017729282e-13);
    return clamp(max(p + p, 0.0) + (t / r) * 9.094947017729282e-13, 0.0, 1.0);
}

// sg_A_h_positive returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_positive(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_positive(lambda, cos_theta), lambda);
}

// quick: Root over a quartic bell (tier, 2026).
// sg_L_quick returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.000995 at lambda 36.43, beta 1.571 (cos_theta 0); RMSE 0.000511
//   double  max 0.000995 at lambda 36.43, beta 1.571 (cos_theta 0); RMSE 0.000511
// Cost on navi21: L 20 instructions, inverse throughput 6; A_h 46 instructions, inverse throughput
//   32
// Source: sgfit fit quick (fit/recipes/quick.json)
// Made by: sgfit fit quick
// Form root_quartic: half the odd part and a root, over a quartic bell: the cheapest of the family.
// With p = z m / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and t = T (T
// + 2 |p|), T = L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even
// analytic function of lambda and of z: no crease at the terminator, and one polynomial in s =
// 1/sqrt(lambda^2 + ...) serves from lambda = 0 to infinity. Here the bell is s u^4, u linear in
// (lambda z)^2 and cut off at 0. lambda is held where its square is a float.
float sg_L_quick(float lambda, float cos_theta)
{
    const float b = 5.511052878007221;
    const float m1 = -0.4827705875052559;
    const float m2 = 1.1678943585278665;
    const float m3 = -1.5104012256577986;
    const float e0 = 0.624134665234732;
    const float e1 = -0.01012562504042444;
    const float k0 = 0.07776602835857983;
    float l = min(lambda, 1e18);
    float s = inversesqrt(l * l + b);
    float a = l * cos_theta;
    float q = a * s;
    float p = q * (0.5 + s * (m1 + s * (m2 + s * m3)));
    float u = clamp((e0 + e1 * s) - (k0 * a) * q, 0.0, 1.0);
    u = u * u;
    u = u * u;
    return clamp(p + sqrt(p * p + s * u), 0.0, 1.0);
}

// sg_A_h_quick returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_quick(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_quick(lambda, cos_theta), lambda);
}

// split: Root over a Gaussian bell in cos_theta (tier, 2026).
// sg_L_split returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 1.01e-05 at lambda 5.915, beta 3.123 (cos_theta -0.9998); RMSE 3.89e-06
//   double  max 1.01e-05 at lambda 5.915, beta 3.142 (cos_theta -1); RMSE 3.89e-06
// Cost on navi21: L 45 instructions, inverse throughput 43; A_h 71 instructions, inverse throughput
//   76
// Source: sgfit fit split (fit/recipes/split.json)
// Made by: sgfit fit split
// Form root_bell_split: half the odd part and a root, over a Gaussian bell in cos_theta, for many
// pixels a lobe. With p = z m / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L,
// exactly) and t = T (T + 2 |p|), T = L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds,
// and t is an even analytic function of lambda and of z: no crease at the terminator, and one
// polynomial in s = 1/sqrt(lambda^2 + ...) serves from lambda = 0 to infinity. The bell t =
// (polynomial in v) 2^(-k v) in v = cos_theta^2: what depends on lambda alone, five numbers, can be
// prepared once a lobe, and a compiler does so where lambda is uniform. The inner quotient moves
// the poles of m, at lambda = i pi, out of the way. lambda is held where its square is a float.
float sg_L_split(float lambda, float cos_theta)
{
    const float b = 8.851255374362474;
    const float b1 = 156.7956548174273;
    const float b2 = 81.53311603142151;
    const float m1 = -0.4985159108304647;
    const float m2 = 2.0693333619153425;
    const float e0 = 0.15908981061445657;
    const float e1 = -0.11878266887314917;
    const float e2 = 0.6789241503681536;
    const float e3 = -0.13107093155825952;
    const float e4 = 2.2912856234337013;
    const float k0 = 0.739975443197133;
    const float k1 = -2.5543930256908864;
    const float k2 = -1.5040247416239403;
    const float k3 = 29.273391342076195;
    const float k4 = -35.03287333539292;
    const float a0 = -0.008455157384544628;
    const float a1 = -0.23127280793823596;
    const float c0 = 3.782596229558713e-4;
    const float c1 = -1.9310877265133733e-4;
    const float c2 = 0.13341946999338866;
    const float c3 = 0.10461695180222876;
    const float c4 = -1.6310068989037692;
    float l = min(lambda, 1e18);
    float h = l * l + b;
    float s = inversesqrt(h + b1 / (h + b2));
    float x = l * s;
    float y = l * x;
    float half_m = x * (0.5 + s * (m1 + s * m2));
    float k = y * (k0 + s * (k1 + s * (k2 + s * (k3 + s * k4))));
    float t0 = s * (e0 + s * (e1 + s * (e2 + s * (e3 + s * e4))));
    float t1 = (s * y) * (a0 + s * a1);
    float t2 = (s * y) * y * (c0 + s * (c1 + s * (c2 + s * (c3 + s * c4))));
    float p = half_m * cos_theta;
    float v = cos_theta * cos_theta;
    float t = t0 + v * (t1 + v * t2);
    return clamp(p + sqrt(p * p + t * exp2(-k * v)), 0.0, 1.0);
}

// sg_A_h_split returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_split(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_split(lambda, cos_theta), lambda);
}

// standard: Root over a Gaussian bell, three terms (tier, 2026).
// sg_L_standard returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 6.71e-06 at lambda 5.032, beta 0.05969 (cos_theta 0.9982); RMSE 3.93e-06
//   double  max 6.6e-06 at lambda 5.032, beta 0 (cos_theta 1); RMSE 3.93e-06
// Cost on navi21: L 45 instructions, inverse throughput 41; A_h 71 instructions, inverse throughput
//   74
// Source: sgfit fit standard (fit/recipes/standard.json)
// Made by: sgfit fit standard
// Form root_bell_3: half the odd part and a root, over a Gaussian bell with three terms. With p = z
// m / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and t = T (T + 2 |p|), T
// = L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even analytic function
// of lambda and of z: no crease at the terminator, and one polynomial in s = 1/sqrt(lambda^2 + ...)
// serves from lambda = 0 to infinity. g = s (lambda z)^2; the bell t = s (polynomial in g, its
// coefficients polynomials in s) 2^(-k g). The inner quotient moves the poles of m, at lambda = i
// pi, out of the way. lambda is held where its square is a float, g where its powers are; exp2 has
// vanished long before.
float sg_L_standard(float lambda, float cos_theta)
{
    const float b = 8.204608972701529;
    const float b1 = 150.3229144350623;
    const float b2 = 95.56507857568361;
    const float m1 = -0.4989149733057123;
    const float m2 = 1.9347765429038537;
    const float m3 = -0.1601680759707647;
    const float m4 = -1.556490388739207;
    const float e0 = 0.15906563608246832;
    const float e1 = -0.11443962895364539;
    const float e2 = 0.5401459535732135;
    const float e3 = 0.48007618487093917;
    const float k0 = 0.685515889879361;
    const float k1 = -0.593528927477311;
    const float k2 = -6.523225494036482;
    const float k3 = 8.911276314599508;
    const float a0 = -0.014903964455727798;
    const float a1 = 0.0024720064748624455;
    const float a2 = -0.8456906638459399;
    const float c0 = 0.0011049588199589346;
    const float c1 = -0.016638225368635053;
    const float c2 = 0.011850853845462828;
    const float c3 = 0.5105966197458224;
    const float d0 = -3.0388569944486813e-5;
    const float d1 = -2.1750442388810104e-4;
    const float d2 = 0.020159783682664936;
    const float d3 = -0.07751177302005666;
    float l = min(lambda, 1e18);
    float h = l * l + b;
    float s = inversesqrt(h + b1 / (h + b2));
    float a = l * cos_theta;
    float q = a * s;
    float p = q * (0.5 + s * (m1 + s * (m2 + s * (m3 + s * m4))));
    float g = min(a * q, 1e3);
    float k = k0 + s * (k1 + s * (k2 + s * k3));
    float t = d0 + s * (d1 + s * (d2 + s * d3));
    t = (c0 + s * (c1 + s * (c2 + s * c3))) + g * t;
    t = (a0 + s * (a1 + s * a2)) + g * t;
    t = (e0 + s * (e1 + s * (e2 + s * e3))) + g * t;
    return clamp(p + sqrt(p * p + t * (s * exp2(-k * g))), 0.0, 1.0);
}

// sg_A_h_standard returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_standard(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_standard(lambda, cos_theta), lambda);
}

// tokuyoshi_2022_minimax: Hemispherical Gaussians, error function, minimax (refit, 2026).
// sg_L_tokuyoshi_2022_minimax returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00288 at lambda 5.915, beta 2.215 (cos_theta -0.6004); RMSE 0.000592
//   double  max 0.00288 at lambda 5.915, beta 2.215 (cos_theta -0.6004); RMSE 0.000592
// Cost on navi21: L 363 instructions, inverse throughput 603; A_h 384 instructions, inverse
//   throughput 631
// Source: sgfit fit tokuyoshi_2022_minimax (fit/recipes/tokuyoshi_2022_minimax.json)
// Made by: sgfit fit tokuyoshi_2022_minimax
// Form hemisphere_erf_stable: the clamped cosine as a lobe less a constant, hemispheres by an error
// function; the difference in closed form. With c the cosine's sharpness, the hemisphere of a lobe
// is A/2 (1 + T R), T = tanh(lambda/2), R = erf(t z)/erf(t), and L = alpha/2 (Q (1 + T3 R3) - (1 +
// T R)), where 3 marks the product and Q = A3 e^sharpness3 / (A e^lambda). alpha c is about 1: each
// of Q - 1, T3 - T, t3 - t ... is formed divided by c, from sharpness3 - lambda = c (2 lambda z +
// c)/(sharpness3 + lambda), so that nothing of the difference is lost. Cut at 0 and 1, which the
// model itself passes, to -5.1e-4 at (9.1, z = -0.81) and to 1.00014 at z = 1 for large
// sharpnesses.
float sg_L_tokuyoshi_2022_minimax(float lambda, float cos_theta)
{
    const float cosine_sharpness = 8.456087224148012e-4;
    const float alpha = 1182.246733967815;
    const float t_0 = 0.6000847522446265;
    const float t_1 = 0.5611082394559542;
    const float t_2 = 10.458361782234823;
    float c = cosine_sharpness;
    float z = clamp(cos_theta, -1.0, 1.0);
    float sum = lambda + c;
    float difference = (lambda - c) / sum;
    float product = sum * sqrt(difference * difference + 2.0 * (lambda / sum) * (c / sum) * (1.0 + z));
    float d = (lambda * z + 0.5 * c) / (0.5 * product + 0.5 * lambda);
    float step = c * d;
    // steepness over sharpness, k, and bend = lambda (k3 - k)/step, in v = 1/(1 + lambda)
    float v = 1.0 / (1.0 + lambda);
    float v3 = 1.0 / (1.0 + product);
    float w = lambda * v;
    float w3 = product * v3;
    float below = w * w + v * (t_1 * w + t_2 * v);
    float below3 = w3 * w3 + v3 * (t_1 * w3 + t_2 * v3);
    float k = sqrt(v * (0.5 * w + t_0 * v) / below);
    float k3 = sqrt(v3 * (0.5 * w3 + t_0 * v3) / below3);
    float turn = (0.5 * t_2 - t_0 * t_1) * v * v3 - t_0 * (w * v3 + w3 * v) - 0.5 * w * w3;
    float bend = w * v3 * turn / (below * below3 * (k3 + k));
    // steps of t z and of t, over c
    float tz_step = k3 + z * d * bend;
    float t_step = d * (k3 + bend);
    // at t = 0 R is z; next to it the quotient is that to 1e-9
    float t = max(k * lambda, 1.0e-4);
    float ratio = sg_erf(t * z) / sg_erf(t);
    float small = max(product, 1.0e-4);
    float tanh3 = sg_tanh_half(product);
    float tanh1 = sg_tanh_half(lambda);
    float rise = tz_step * sg_erf_step(k * lambda * z + 0.5 * c * tz_step, c * tz_step)
        - ratio * t_step * sg_erf_step(k * lambda + 0.5 * c * t_step, c * t_step);
    // (T3 R3 - T R)/c = (T3 - T) R/c + T3 (R3 - R)/c
    float tanh_step = 0.5 * d * (1.0 - step * step * 0.0833333333333333333) * (1.0 - tanh1 * tanh3);
    float bias_step = tanh_step * ratio + sg_tanh_half(small) / sg_erf(k3 * small) * rise;
    float bias3 = tanh1 * ratio + c * bias_step;
    float value = 0.5 * alpha * c * (d * sg_gain_step(lambda, product, step) * (1.0 + bias3) + bias_step);
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : clamp(value, 0.0, 1.0);
}

// sg_A_h_tokuyoshi_2022_minimax returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_tokuyoshi_2022_minimax(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_tokuyoshi_2022_minimax(lambda, cos_theta), lambda);
}

// tokuyoshi_2022_refit: Hemispherical Gaussians, error function, least squares (refit, 2026).
// sg_L_tokuyoshi_2022_refit returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00298 at lambda 5.68, beta 2.224 (cos_theta -0.6079); RMSE 0.000478
//   double  max 0.00298 at lambda 5.68, beta 2.224 (cos_theta -0.6079); RMSE 0.000478
// Cost on navi21: L 363 instructions, inverse throughput 603; A_h 384 instructions, inverse
//   throughput 631
// Source: sgfit fit tokuyoshi_2022_refit (fit/recipes/tokuyoshi_2022_refit.json)
// Made by: sgfit fit tokuyoshi_2022_refit
// Form hemisphere_erf_stable: the clamped cosine as a lobe less a constant, hemispheres by an error
// function; the difference in closed form. With c the cosine's sharpness, the hemisphere of a lobe
// is A/2 (1 + T R), T = tanh(lambda/2), R = erf(t z)/erf(t), and L = alpha/2 (Q (1 + T3 R3) - (1 +
// T R)), where 3 marks the product and Q = A3 e^sharpness3 / (A e^lambda). alpha c is about 1: each
// of Q - 1, T3 - T, t3 - t ... is formed divided by c, from sharpness3 - lambda = c (2 lambda z +
// c)/(sharpness3 + lambda), so that nothing of the difference is lost. Cut at 0 and 1, which the
// model itself passes, to -5.1e-4 at (9.1, z = -0.81) and to 1.00014 at z = 1 for large
// sharpnesses.
float sg_L_tokuyoshi_2022_refit(float lambda, float cos_theta)
{
    const float cosine_sharpness = 8.456087224148012e-4;
    const float alpha = 1182.246733967815;
    const float t_0 = 1.2660830562478809;
    const float t_1 = 1.7274392922245883;
    const float t_2 = 12.60937155649192;
    float c = cosine_sharpness;
    float z = clamp(cos_theta, -1.0, 1.0);
    float sum = lambda + c;
    float difference = (lambda - c) / sum;
    float product = sum * sqrt(difference * difference + 2.0 * (lambda / sum) * (c / sum) * (1.0 + z));
    float d = (lambda * z + 0.5 * c) / (0.5 * product + 0.5 * lambda);
    float step = c * d;
    // steepness over sharpness, k, and bend = lambda (k3 - k)/step, in v = 1/(1 + lambda)
    float v = 1.0 / (1.0 + lambda);
    float v3 = 1.0 / (1.0 + product);
    float w = lambda * v;
    float w3 = product * v3;
    float below = w * w + v * (t_1 * w + t_2 * v);
    float below3 = w3 * w3 + v3 * (t_1 * w3 + t_2 * v3);
    float k = sqrt(v * (0.5 * w + t_0 * v) / below);
    float k3 = sqrt(v3 * (0.5 * w3 + t_0 * v3) / below3);
    float turn = (0.5 * t_2 - t_0 * t_1) * v * v3 - t_0 * (w * v3 + w3 * v) - 0.5 * w * w3;
    float bend = w * v3 * turn / (below * below3 * (k3 + k));
    // steps of t z and of t, over c
    float tz_step = k3 + z * d * bend;
    float t_step = d * (k3 + bend);
    // at t = 0 R is z; next to it the quotient is that to 1e-9
    float t = max(k * lambda, 1.0e-4);
    float ratio = sg_erf(t * z) / sg_erf(t);
    float small = max(product, 1.0e-4);
    float tanh3 = sg_tanh_half(product);
    float tanh1 = sg_tanh_half(lambda);
    float rise = tz_step * sg_erf_step(k * lambda * z + 0.5 * c * tz_step, c * tz_step)
        - ratio * t_step * sg_erf_step(k * lambda + 0.5 * c * t_step, c * t_step);
    // (T3 R3 - T R)/c = (T3 - T) R/c + T3 (R3 - R)/c
    float tanh_step = 0.5 * d * (1.0 - step * step * 0.0833333333333333333) * (1.0 - tanh1 * tanh3);
    float bias_step = tanh_step * ratio + sg_tanh_half(small) / sg_erf(k3 * small) * rise;
    float bias3 = tanh1 * ratio + c * bias_step;
    float value = 0.5 * alpha * c * (d * sg_gain_step(lambda, product, step) * (1.0 + bias3) + bias_step);
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : clamp(value, 0.0, 1.0);
}

// sg_A_h_tokuyoshi_2022_refit returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_tokuyoshi_2022_refit(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_tokuyoshi_2022_refit(lambda, cos_theta), lambda);
}

// tokuyoshi_2024_minimax: Planar Gaussian between the poles, minimax (refit, 2026).
// sg_L_tokuyoshi_2024_minimax returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00119 at lambda 6.158, beta 1.571 (cos_theta 0); RMSE 0.000233
//   double  max 0.00119 at lambda 6.158, beta 1.571 (cos_theta 0); RMSE 0.000233
// Cost on navi21: L 180 instructions, inverse throughput 259; A_h 202 instructions, inverse
//   throughput 288
// Source: sgfit fit tokuyoshi_2024_minimax (fit/recipes/tokuyoshi_2024_minimax.json)
// Made by: sgfit fit tokuyoshi_2024_minimax
// Form cosine_erf_stable: between the poles by the integral of a planar Gaussian times a clamped
// plane; L from the start. The steepness is written in v = 1/(1 + lambda), so that no power of
// lambda overflows, and expm1(y)/t as t expm1(y)/t^2, which is not 0/0 at lambda = 0.
float sg_L_tokuyoshi_2024_minimax(float lambda, float cos_theta)
{
    const float t_a = -0.662857859095474;
    const float t_b = 18.793952734439696;
    const float t_c = 0.7530976047835686;
    const float t_d = 11.938356311433592;
    const float t_e = 69.81778092207479;
    float z = clamp(cos_theta, -1.0, 1.0);
    float v = 1.0 / (1.0 + lambda);
    float w = 1.0 - v;
    float above = w * w + v * (t_a * w + t_b * v);
    float below = w * w * w + v * (t_c * w * w + v * (t_d * w + t_e * v));
    float t = lambda * sqrt(0.5 * v * above / below);
    float side = (1.0 - z) * (1.0 + z);
    float bell = exp(-(t * z) * (t * z)) * side * t * sg_one_minus_exp_over(t * t * side);
    // 1/(2 sqrt(pi))
    float s = 0.5 * (z * sg_erfc(-t * z) + sg_erfc(t)) + 0.282094791773878143 * bell;
    float value = max(sg_L_b(lambda) + sg_mean(lambda) * s, 0.0);
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : value;
}

// sg_A_h_tokuyoshi_2024_minimax returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_tokuyoshi_2024_minimax(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_tokuyoshi_2024_minimax(lambda, cos_theta), lambda);
}

// tokuyoshi_2024_refit: Planar Gaussian between the poles, least squares (refit, 2026).
// sg_L_tokuyoshi_2024_refit returns L, in [0, 1] up to its error.
// Domain: lambda in [0, inf), cos_theta in [-1, 1].
// Error of L:
//   float   max 0.00122 at lambda 5.915, beta 0.8702 (cos_theta 0.6447); RMSE 0.000193
//   double  max 0.00122 at lambda 5.915, beta 2.271 (cos_theta -0.6447); RMSE 0.000193
// Cost on navi21: L 180 instructions, inverse throughput 259; A_h 202 instructions, inverse
//   throughput 288
// Source: sgfit fit tokuyoshi_2024_refit (fit/recipes/tokuyoshi_2024_refit.json)
// Made by: sgfit fit tokuyoshi_2024_refit
// Form cosine_erf_stable: between the poles by the integral of a planar Gaussian times a clamped
// plane; L from the start. The steepness is written in v = 1/(1 + lambda), so that no power of
// lambda overflows, and expm1(y)/t as t expm1(y)/t^2, which is not 0/0 at lambda = 0.
float sg_L_tokuyoshi_2024_refit(float lambda, float cos_theta)
{
    const float t_a = 2.5590918205240856;
    const float t_b = 19.903881677887842;
    const float t_c = 3.956182780692124;
    const float t_d = 15.611733053042547;
    const float t_e = 88.0516453926341;
    float z = clamp(cos_theta, -1.0, 1.0);
    float v = 1.0 / (1.0 + lambda);
    float w = 1.0 - v;
    float above = w * w + v * (t_a * w + t_b * v);
    float below = w * w * w + v * (t_c * w * w + v * (t_d * w + t_e * v));
    float t = lambda * sqrt(0.5 * v * above / below);
    float side = (1.0 - z) * (1.0 + z);
    float bell = exp(-(t * z) * (t * z)) * side * t * sg_one_minus_exp_over(t * t * side);
    // 1/(2 sqrt(pi))
    float s = 0.5 * (z * sg_erfc(-t * z) + sg_erfc(t)) + 0.282094791773878143 * bell;
    float value = max(sg_L_b(lambda) + sg_mean(lambda) * s, 0.0);
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= 5.316911983139663e36 ? max(z, 0.0) : value;
}

// sg_A_h_tokuyoshi_2024_refit returns A_h, in [0, pi] up to its error, which is that of L times
// sg_integral(lambda).
// Domain, error and source: above.
float sg_A_h_tokuyoshi_2024_refit(float lambda, float cos_theta)
{
    return sg_A_h_from_L(sg_L_tokuyoshi_2024_refit(lambda, cos_theta), lambda);
}

// A spherical Gaussian amplitude * exp(sharpness * (dot(w, axis) - 1)). axis: unit length.
// sharpness: lambda, in [0, 1e37]; 0 is a constant, larger is narrower. amplitude: the value at the
// axis, for each colour channel.
struct sg_lobe {
    vec3 axis;
    float sharpness;
    vec3 amplitude;
};

// The lobe's value in a direction of unit length, in [0, amplitude]; accurate next to the axis at
// any sharpness.
vec3 sg_evaluate_lobe(sg_lobe lobe, vec3 direction)
{
    vec3 difference = direction - lobe.axis;
    return lobe.amplitude * sg_evaluate_near(lobe.sharpness, dot(difference, difference));
}

// The product of two lobes, which is a lobe again. Sharpnesses in [0, 1e37]. Where the product is
// constant (opposite axes, equal sharpness) its sharpness is 0 and its axis perpendicular to both.
// Source: Xu et al. 2014; Meder and Bruederlin 2018, eq. 3.
sg_lobe sg_product(sg_lobe a, sg_lobe b)
{
    vec3 sum = a.axis + b.axis;
    vec3 difference = a.axis - b.axis;
    float total = a.sharpness + b.sharpness;
    float lean = total > 0.0 ? (a.sharpness - b.sharpness) / total : 0.0;
    vec3 axis = 0.5 * sum + 0.5 * lean * difference;
    float size = length(axis);
    vec3 other = abs(a.axis.z) < 0.5 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    sg_lobe product;
    product.axis = size > 0.0 ? axis / size : normalize(cross(a.axis, other));
    product.sharpness = sg_product_sharpness(a.sharpness, b.sharpness, dot(sum, sum));
    product.amplitude = a.amplitude * b.amplitude *
        exp(sg_product_log_amplitude(a.sharpness, b.sharpness, product.sharpness,
                                     dot(difference, difference)));
    return product;
}

// The lobe's integral over the sphere: amplitude times 2 pi (1 - e^-2lambda)/lambda, 4 pi at 0.
vec3 sg_integrate_lobe(sg_lobe lobe)
{
    return lobe.amplitude * sg_integral(lobe.sharpness);
}

// Irradiance of a surface from one lobe of light: the integral of the lobe times
// max(dot(w, normal), 0) over the sphere, in [0, pi amplitude] up to the method's error. For a
// Lambertian surface the outgoing radiance is albedo/pi times this. axis and normal: unit length;
// sharpness: the method's domain, see sg_A_h_standard above.
vec3 sg_irradiance(vec3 amplitude, vec3 axis, float sharpness, vec3 normal)
{
    return amplitude * sg_A_h_standard(sharpness, clamp(dot(axis, normal), -1.0, 1.0));
}

#endif
