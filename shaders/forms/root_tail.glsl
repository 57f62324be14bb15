// root_tail: half the odd part and a root, the far tail kept in proportion.
// computes: L
// coefficients: b m1 m2 m3 m4 e0 e1 e2 k0 a0 a1 a2 c0 c1 c2 d0 d1
// source: fit/recipes/positive.json
// With p = z m / 2 (m = coth lambda - 1/lambda, so 2 p is the odd part of L, exactly) and
// t = T (T + 2 |p|), T = L(lambda, -|z|), the identity L = p + sqrt(p^2 + t) holds, and t is an even
// analytic function of lambda and of z: no crease at the terminator, and one polynomial in
// s = 1/sqrt(lambda^2 + ...) serves from lambda = 0 to infinity.
// At the back L = t / (|p| + root), which does not cancel. The bell follows the lobe instead of its
// Gaussian: w = sqrt(lambda^2 + b) - sqrt(lambda^2 (1 - z^2) + b), and t = s (polynomial in s) 2^(-k w)
// / sqrt(d), d a polynomial in w and s.
// t is carried 2^40 times too large, since it is the square of a tail that may itself be as small as a
// float can be; lambda is held where its square is a float.
real sg_form(real lambda, real cos_theta)
{
    real l = min(lambda, K(1e18));
    real h = l * l + b;
    real s = inversesqrt(h);
    real a = l * cos_theta;
    real p = (a * s) * (K(0.5) + s * (m1 + s * (m2 + s * (m3 + s * m4))));
    real w = a * (a / (h * s + sqrt(max(h - a * a, b))));
    real y = w * s;
    real d = (c0 + s * (c1 + s * c2)) + y * (d0 + s * d1);
    d = K(1.0) + w * ((a0 + s * (a1 + s * a2)) + y * d);
    real u = exp2(K(40.0) - k0 * w) * inversesqrt(max(d, K(0.1)));
    real t = (e0 + s * (e1 + s * e2)) * (s * u);
    real r = abs(p) + sqrt(p * p + t * K(9.094947017729282e-13));
    return clamp(max(p + p, K(0.0)) + (t / r) * K(9.094947017729282e-13), K(0.0), K(1.0));
}
