// hemisphere_erf_stable: the clamped cosine as a lobe less a constant, hemispheres by an error function; the difference in closed form.
// computes: L
// coefficients: cosine_sharpness alpha t_0 t_1 t_2
// source: Tokuyoshi 2022, sections 2 and 3
// With c the cosine's sharpness, the hemisphere of a lobe is A/2 (1 + T R), T = tanh(lambda/2), R =
// erf(t z)/erf(t), and
//   L = alpha/2 (Q (1 + T3 R3) - (1 + T R)),
// where 3 marks the product and Q = A3 e^sharpness3 / (A e^lambda). alpha c is about 1: each of Q -
// 1, T3 - T, t3 - t ... is formed divided by c, from sharpness3 - lambda = c (2 lambda z +
// c)/(sharpness3 + lambda), so that nothing of the difference is lost. Cut at 0 and 1, which the
// model itself passes, to -5.1e-4 at (9.1, z = -0.81) and to 1.00014 at z = 1 for large sharpnesses.
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
    real below = w * w + v * (t_1 * w + t_2 * v);
    real below3 = w3 * w3 + v3 * (t_1 * w3 + t_2 * v3);
    real k = sqrt(v * (K(0.5) * w + t_0 * v) / below);
    real k3 = sqrt(v3 * (K(0.5) * w3 + t_0 * v3) / below3);
    real turn = (K(0.5) * t_2 - t_0 * t_1) * v * v3 - t_0 * (w * v3 + w3 * v) - K(0.5) * w * w3;
    real bend = w * v3 * turn / (below * below3 * (k3 + k));
    // steps of t z and of t, over c
    real tz_step = k3 + z * d * bend;
    real t_step = d * (k3 + bend);
    // at t = 0 R is z; next to it the quotient is that to 1e-9
    real t = max(k * lambda, K(1.0e-4));
    real ratio = sg_erf(t * z) / sg_erf(t);
    real small = max(product, K(1.0e-4));
    real tanh3 = sg_tanh_half(product);
    real tanh1 = sg_tanh_half(lambda);
    real rise = tz_step * sg_erf_step(k * lambda * z + K(0.5) * c * tz_step, c * tz_step)
        - ratio * t_step * sg_erf_step(k * lambda + K(0.5) * c * t_step, c * t_step);
    // (T3 R3 - T R)/c = (T3 - T) R/c + T3 (R3 - R)/c
    real tanh_step = K(0.5) * d * (K(1.0) - step * step * K(0.0833333333333333333)) * (K(1.0) - tanh1 * tanh3);
    real bias_step = tanh_step * ratio + sg_tanh_half(small) / sg_erf(k3 * small) * rise;
    real bias3 = tanh1 * ratio + c * bias_step;
    real value = K(0.5) * alpha * c * (d * sg_gain_step(lambda, product, step) * (K(1.0) + bias3) + bias_step);
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= K(5.316911983139663e36) ? max(z, K(0.0)) : clamp(value, K(0.0), K(1.0));
}
