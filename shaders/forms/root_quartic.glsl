// root_quartic: half the odd part and a root, over a quartic bell: the cheapest of the family.
// computes: L
// coefficients: b m1 m2 m3 e0 e1 k0
// source: fit/recipes/quick.json
// With p = z m / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and
// t = T (T + 2 |p|), T = L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even
// analytic function of lambda and of z: no crease at the terminator, and one polynomial in
// s = 1/sqrt(lambda^2 + ...) serves from lambda = 0 to infinity.
// Here the bell is s u^4, u linear in (lambda z)^2 and cut off at 0.
// lambda is held where its square is a float.
real sg_form(real lambda, real cos_theta)
{
    real l = min(lambda, K(1e18));
    real s = inversesqrt(l * l + b);
    real a = l * cos_theta;
    real q = a * s;
    real p = q * (K(0.5) + s * (m1 + s * (m2 + s * m3)));
    real u = clamp((e0 + e1 * s) - (k0 * a) * q, K(0.0), K(1.0));
    u = u * u;
    u = u * u;
    return clamp(p + sqrt(p * p + s * u), K(0.0), K(1.0));
}
