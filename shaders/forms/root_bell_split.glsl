// root_bell_split: half the odd part and a root, over a Gaussian bell in cos_theta, for many pixels a lobe.
// computes: L
// coefficients: b b1 b2 m1 m2 e0 e1 e2 e3 e4 k0 k1 k2 k3 k4 a0 a1 c0 c1 c2 c3 c4
// source: fit/recipes/split.json
// With p = z m / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and
// t = T (T + 2 |p|), T = L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even
// analytic function of lambda and of z: no crease at the terminator, and one polynomial in
// s = 1/sqrt(lambda^2 + ...) serves from lambda = 0 to infinity.
// The bell t = (polynomial in v) 2^(-k v) in v = cos_theta^2: what depends on lambda alone, five numbers,
// can be prepared once a lobe, and a compiler does so where lambda is uniform.
// The inner quotient moves the poles of m, at lambda = i pi, out of the way.
// lambda is held where its square is a float.
real sg_form(real lambda, real cos_theta)
{
    real l = min(lambda, K(1e18));
    real h = l * l + b;
    real s = inversesqrt(h + b1 / (h + b2));
    real x = l * s;
    real y = l * x;
    real half_m = x * (K(0.5) + s * (m1 + s * m2));
    real k = y * (k0 + s * (k1 + s * (k2 + s * (k3 + s * k4))));
    real t0 = s * (e0 + s * (e1 + s * (e2 + s * (e3 + s * e4))));
    real t1 = (s * y) * (a0 + s * a1);
    real t2 = (s * y) * y * (c0 + s * (c1 + s * (c2 + s * (c3 + s * c4))));
    real p = half_m * cos_theta;
    real v = cos_theta * cos_theta;
    real t = t0 + v * (t1 + v * t2);
    return clamp(p + sqrt(p * p + t * exp2(-k * v)), K(0.0), K(1.0));
}
