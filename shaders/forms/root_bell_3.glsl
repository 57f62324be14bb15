// root_bell_3: half the odd part and a root, over a Gaussian bell with three terms.
// computes: L
// coefficients: b b1 b2 m1 m2 m3 m4 e0 e1 e2 e3 k0 k1 k2 k3 a0 a1 a2 c0 c1 c2 c3 d0 d1 d2 d3
// source: fit/recipes/standard.json
// With p = z m / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and
// t = T (T + 2 |p|), T = L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even
// analytic function of lambda and of z: no crease at the terminator, and one polynomial in
// s = 1/sqrt(lambda^2 + ...) serves from lambda = 0 to infinity.
// g = s (lambda z)^2; the bell t = s (polynomial in g, its coefficients polynomials in s) 2^(-k g).
// The inner quotient moves the poles of m, at lambda = i pi, out of the way.
// lambda is held where its square is a float, g where its powers are; exp2 has vanished long before.
real sg_form(real lambda, real cos_theta)
{
    real l = min(lambda, K(1e18));
    real h = l * l + b;
    real s = inversesqrt(h + b1 / (h + b2));
    real a = l * cos_theta;
    real q = a * s;
    real p = q * (K(0.5) + s * (m1 + s * (m2 + s * (m3 + s * m4))));
    real g = min(a * q, K(1e3));
    real k = k0 + s * (k1 + s * (k2 + s * k3));
    real t = d0 + s * (d1 + s * (d2 + s * d3));
    t = (c0 + s * (c1 + s * (c2 + s * c3))) + g * t;
    t = (a0 + s * (a1 + s * a2)) + g * t;
    t = (e0 + s * (e1 + s * (e2 + s * e3))) + g * t;
    return clamp(p + sqrt(p * p + t * (s * exp2(-k * g))), K(0.0), K(1.0));
}
