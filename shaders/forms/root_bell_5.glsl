// root_bell_5: half the odd part and a root, over a Gaussian bell with five terms.
// computes: L
// coefficients: b b1 b2 m1 m2 m3 m4 m5 m6 e0 e1 e2 e3 e4 e5 e6 k0 k1 k2 k3 k4 k5 k6 a0 a1 a2 a3 a4 c0 c1 c2 c3 c4 c5 d0 d1 d2 d3 d4 d5 f0 f1 f2 f3 j0 j1 j2
// source: fit/recipes/fine.json
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
    real p = q * (K(0.5) + s * (m1 + s * (m2 + s * (m3 + s * (m4 + s * (m5 + s * m6))))));
    real g = min(a * q, K(1e3));
    real k = k0 + s * (k1 + s * (k2 + s * (k3 + s * (k4 + s * (k5 + s * k6)))));
    real t = j0 + s * (j1 + s * j2);
    t = (f0 + s * (f1 + s * (f2 + s * f3))) + g * t;
    t = (d0 + s * (d1 + s * (d2 + s * (d3 + s * (d4 + s * d5))))) + g * t;
    t = (c0 + s * (c1 + s * (c2 + s * (c3 + s * (c4 + s * c5))))) + g * t;
    t = (a0 + s * (a1 + s * (a2 + s * (a3 + s * a4)))) + g * t;
    t = (e0 + s * (e1 + s * (e2 + s * (e3 + s * (e4 + s * (e5 + s * e6)))))) + g * t;
    return clamp(p + sqrt(p * p + t * (s * exp2(-k * g))), K(0.0), K(1.0));
}
