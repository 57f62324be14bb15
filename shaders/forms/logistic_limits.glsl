// logistic_limits: Meder's logistic weight with a t and a u that have the exact limits at lambda = 0 and infinity.
// computes: L
// coefficients: t_infinity u_infinity p_1 q_1 q_2 q_3 u_1
// source: this project; the structure is Meder and Bruederlin 2018, eqs 15 to 17
// t -> 3/8 lambda and u -> 2 - 3/8 lambda at 0, t -> t_infinity sqrt(lambda) and u -> u_infinity/sqrt(lambda) at
// infinity. t is a rational function of v = 1/(1 + lambda), in which nothing overflows, and 1/u - 1/2 one of t.
// L is written as m max(z, 0) plus the rest, so that L(z) - L(-z) = z m holds exactly.
real sg_form(real lambda, real cos_theta)
{
    real z = clamp(cos_theta, K(-1.0), K(1.0));
    real size = abs(z);
    real v = K(1.0) / (K(1.0) + lambda);
    real p_0 = t_infinity * t_infinity;
    real p_2 = K(0.140625) * (K(1.0) + q_1 + q_2 + q_3) - p_0 - p_1;
    real t = lambda * sqrt(v * (p_0 + v * (p_1 + v * p_2))
        / (K(1.0) + v * (q_1 + v * (q_2 + v * q_3))));
    real slope = u_1 / (u_infinity * t_infinity);
    real u = (K(1.0) + u_1 * t) / (K(0.5) + t * (K(0.25) + K(0.5) * u_1 + slope * t));
    real e = exp(-t * size);
    real c = max(z, K(0.0)) + K(0.5) * u * e / (K(1.0) + e) * (K(1.0) - size);
    real value = sg_L_b(lambda) + sg_mean(lambda) * c;
    // 2^122, the same number in float and double, stands for infinity
    return lambda >= K(5.316911983139663e36) ? max(z, K(0.0)) : value;
}
