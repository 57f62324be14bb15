// sg_product_log_amplitude: logarithm of what the amplitude of a product of two lobes loses, in (-inf, 0].
// lambda3 - lambda1 - lambda2, lambda3 the product's sharpness, from |v1 - v2|^2 in [0, 4] and
// without cancellation: -lambda1 lambda2 |v1 - v2|^2/(lambda1 + lambda2 + lambda3).
// source: Xu et al. 2014; Meder and Bruederlin 2018, eq. 3
real sg_product_log_amplitude(real lambda1, real lambda2, real lambda3, real difference_squared)
{
    real total = lambda1 + lambda2 + lambda3;
    return -lambda1 * (lambda2 / (total > K(0.0) ? total : K(1.0))) * difference_squared;
}
