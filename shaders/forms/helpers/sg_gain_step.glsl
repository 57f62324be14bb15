// sg_gain_step: (Q - 1)/step, Q = sinh(product)/product over sinh(lambda)/lambda, product = lambda + step.
// Q is what the integral of a lobe over the sphere gains when the lobe is multiplied by e^(c (w.n)) and
// has the sharpness `product` afterwards. |step| < 0.05. No difference of nearly equal numbers: below 1
// the divided difference of the power series in x^2 (cut where 6/13! follows), elsewhere
// Q - 1 = (lambda (cosh step - 1) + lambda coth(lambda) sinh(step) - step)/product.
real sg_gain_step(real lambda, real product, real step)
{
    real q = lambda * lambda;
    real p = product * product;
    real s1 = p + q;
    real s2 = p * s1 + q * q;
    real s3 = p * s2 + q * q * q;
    real s4 = p * s3 + q * q * q * q;
    real slope = K(0.166666666666666667) + K(0.00833333333333333333) * s1 + K(1.98412698412698413e-4) * s2
        + K(2.75573192239858907e-6) * s3 + K(2.50521083854417188e-8) * s4;
    real sinhc = K(1.0) + q * (K(0.166666666666666667) + q * (K(0.00833333333333333333) + q * (K(1.98412698412698413e-4)
        + q * (K(2.75573192239858907e-6) + q * K(2.50521083854417188e-8)))));
    real mean = sg_mean(lambda);
    real ratio = lambda / product;
    real h = step * step;
    real outer = ratio * (mean + K(0.5) * step * (K(1.0) + h * K(0.0833333333333333333)))
        + (K(1.0) / product + ratio * mean) * h * (K(0.166666666666666667) + h * K(0.00833333333333333333));
    return lambda < K(1.0) ? (lambda + product) * slope / sinhc : outer;
}
