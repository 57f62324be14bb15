// sg_L_from_A_h: L of a method whose text computes A_h.
// Where the integral over the sphere has run out of range (an infinite sharpness) the quotient's
// limit, the clamped cosine; NaN stays NaN.
real sg_L_from_A_h(real A_h, real lambda, real cos_theta)
{
    real area = sg_integral(lambda);
    return area == K(0.0) ? max(cos_theta, K(0.0)) : A_h / area;
}
