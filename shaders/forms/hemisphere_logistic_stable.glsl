// hemisphere_logistic_stable: the clamped cosine as a lobe less a constant, hemispheres by a logistic curve; the difference in closed form.
// computes: L
// coefficients: cosine_sharpness cosine_scale cosine_rest t_cubic t_square t_linear t_constant
// source: Meder and Bruederlin 2018 (Hemispherical Gaussians)
// As hemisphere_erf_stable, with R = tanh(t z/2)/tanh(t/2), which is 2s - 1 of the published
// logistic s, and with
//   L = scale/2 (Q (1 + T3 R3) - (1 + T R)) + rest/2 (1 + T R),
// where scale = amplitude e^-c and rest = scale - offset are coefficients, because their difference
// cancels. Cut at 0 and 1: at grazing angles the model itself is negative, down to rest/2 at z = 0 and to
// rest just above it as the sharpness grows, and at z = 1 it goes up to 1.0077. An infinite sharpness
// gives max(z, 0), not the model's limit.
real sg_form(real lambda, real cos_theta)
{
    real c = cosine_sharpness;
    real z = clamp(cos_theta, K(-1.0), K(1.0));
    real sum = lambda + c;
    real difference = (lambda - c) / sum;
    real product = sum * sqrt(difference * difference + K(2.0) * (lambda / sum) * (c / sum) * (K(1.0) + z));
    real d = (lambda * z + K(0.5) * c) / (K(0.5) * product + K(0.5) * lambda);
    real step = c * d;
    // steepness over sharpness, k, and bend = lambda (k3 - k)/step, in v = 1/(1 + lambda)
    real v = K(1.0) / (K(1.0) + lambda);
    real v3 = K(1.0) / (K(1.0) + product);
    real w = lambda * v;
    real w3 = product * v3;
    real root = sqrt(lambda);
    real root3 = sqrt(product);
    real below = w * w + v * (t_linear * w + t_constant * v);
    real below3 = w3 * w3 + v3 * (t_linear * w3 + t_constant * v3);
    real rate3 = v3 * (t_cubic * w3 + t_square * v3) / below3;
    real k = root * v * (t_cubic * w + t_square * v) / below;
    real k3 = root3 * rate3;
    real turn = (t_cubic * t_constant - t_square * t_linear) * v * v3 - t_square * (w * v3 + w3 * v) - t_cubic * w * w3;
    real bend = lambda * rate3 / (root3 + root) + root * w * v3 * turn / (below * below3);
    // tanh of half the steps of t z and of t, over c
    real tz_half = K(0.5) * (k3 + z * d * bend);
    real t_half = K(0.5) * d * (k3 + bend);
    real tz_square = (c * tz_half) * (c * tz_half) * K(0.333333333333333333);
    real t_square_step = (c * t_half) * (c * t_half) * K(0.333333333333333333);
    real tz_step = tz_half * (K(1.0) - tz_square * (K(1.0) - K(1.2) * tz_square));
    real t_step = t_half * (K(1.0) - t_square_step * (K(1.0) - K(1.2) * t_square_step));
    // at t = 0 R is z; next to it the quotient is that to 1e-9
    real t = max(k * lambda, K(1.0e-4));
    real bent = sg_tanh_half(t * z);
    real full = sg_tanh_half(t);
    real ratio = bent / full;
    real full3 = sg_tanh_half(k3 * product);
    real tanh3 = sg_tanh_half(product);
    real tanh1 = sg_tanh_half(lambda);
    real rise = tz_step * (K(1.0) - bent * bent) / (K(1.0) + c * tz_step * bent)
        - ratio * t_step * (K(1.0) - full * full) / (K(1.0) + c * t_step * full);
    // (T3 R3 - T R)/c = (T3 - T) R/c + T3 (R3 - R)/c
    real half_square = step * step * K(0.0833333333333333333);
    real tanh_step = K(0.5) * d * (K(1.0) - half_square * (K(1.0) - K(1.2) * half_square)) * (K(1.0) - tanh1 * tanh3);
    real stepped = tanh_step * ratio + tanh3 / full3 * rise;
    // where the product's sharpness can vanish both terms are as small as c, and their difference loses nothing
    real ratio3 = full3 > K(0.0) ? sg_tanh_half(k3 * ((c - lambda) + lambda * (K(1.0) + z))) / full3 : K(0.0);
    real direct = (tanh3 * ratio3 - tanh1 * ratio) / c;
    real bias_step = lambda < K(4.0) * c ? direct : stepped;
    real bias = tanh1 * ratio;
    real gain = d * sg_gain_step(lambda, product, step) * (K(1.0) + bias + c * bias_step) + bias_step;
    real value = K(0.5) * (cosine_scale * c * gain + cosine_rest * (K(1.0) + bias));
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= K(5.316911983139663e36) ? max(z, K(0.0)) : clamp(value, K(0.0), K(1.0));
}
