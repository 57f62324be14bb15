// sg_hemisphere_logistic: H, the integral of a lobe over the hemisphere, by a normalised logistic of steepness t.
// As published, s = (ab - 1)/((a - 1)(b + 1)) with a = e^t and b = e^(tz), in the reciprocals a' =
// e^-t and b' = e^-t|z| in which public implementations evaluate it, because a overflows. 0/0 where
// a' rounds to 1.
// source: Meder and Bruederlin 2018 (Hemispherical Gaussians)
real sg_hemisphere_logistic(real lambda, real cos_theta, real t)
{
    real upper = K(2.0) * sg_pi * (K(1.0) - exp(-lambda)) / lambda;
    real lower = exp(-lambda) * upper;
    real a = exp(-t);
    real b = exp(-t * abs(cos_theta));
    real s = (cos_theta < K(0.0) ? b - a : K(1.0) - a * b) / ((K(1.0) - a) * (K(1.0) + b));
    return lower + s * (upper - lower);
}
