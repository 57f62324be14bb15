// root_bell_2: half the odd part and a root, over a Gaussian bell with two terms.
// computes: L
// coefficients: b m1 m2 m3 e0 e1 e2 e3 k0 k1 a0 b0
// source: fit/recipes/medium.json
// With p = z m / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and
// t = T (T + 2 |p|), T = L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even
// analytic function of lambda and of z: no crease at the terminator, and one polynomial in
// s = 1/sqrt(lambda^2 + ...) serves from lambda = 0 to infinity.
// g = s (lambda z)^2; the bell t = s (polynomial in g, its coefficients polynomials in s) 2^(-k g).
// lambda is held where its square is a float.
real sg_form(real lambda, real cos_theta)
{
    real l = min(lambda, K(1e18));
    real s = inversesqrt(l * l + b);
    real a = l * cos_theta;
    real q = a * s;
    real p = q * (K(0.5) + s * (m1 + s * (m2 + s * m3)));
    real g = a * q;
    real t = e0 + s * ((e1 + s * (e2 + s * e3)) + g * (a0 + g * b0));
    real u = exp2(-(k0 + s * k1) * g);
    return clamp(p + sqrt(p * p + t * (s * u)), K(0.0), K(1.0));
}
