// root_bell_1: half the odd part and a root, over a Gaussian bell with one term.
// computes: L
// coefficients: b m1 m2 e0 e1 k0 a0
// source: fit/recipes/brisk.json
// With p = z m / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and
// t = T (T + 2 |p|), T = L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even
// analytic function of lambda and of z: no crease at the terminator, and one polynomial in
// s = 1/sqrt(lambda^2 + ...) serves from lambda = 0 to infinity.
// g = s (lambda z)^2; the bell t = s (polynomial in g, its coefficients polynomials in s) 2^(-k g).
// lambda is held where its square is a float; the literal coefficients are such as a GPU has for free.
real sg_form(real lambda, real cos_theta)
{
    real l = min(lambda, K(1e18));
    real s = inversesqrt(l * l + b);
    real a = l * cos_theta;
    real q = a * s;
    real p = q * (K(0.5) + s * (m1 + s * (m2 - s * K(2.0))));
    real g = a * q;
    real t = e0 + s * ((e1 + s * K(0.5)) + g * a0);
    real u = exp2((s - k0) * g);
    return clamp(p + sqrt(p * p + t * (s * u)), K(0.0), K(1.0));
}
