// sg_product_sharpness: sharpness of the product of two lobes, |lambda1 v1 + lambda2 v2|, from |v1 + v2|^2 in [0, 4].
// No cancellation for opposite axes, no overflow below 1e38; 0 for opposite lobes of equal
// sharpness.
// source: Xu et al. 2014; Meder and Bruederlin 2018, eq. 3
real sg_product_sharpness(real lambda1, real lambda2, real sum_squared)
{
    real total = lambda1 + lambda2;
    real divisor = total > K(0.0) ? total : K(1.0);
    real difference = (lambda1 - lambda2) / divisor;
    return total * sqrt(difference * difference + (lambda1 / divisor) * (lambda2 / divisor) * sum_squared);
}
