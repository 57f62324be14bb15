// sg_evaluate: a lobe of amplitude 1 at the cosine of the angle to its axis, in [0, 1].
// Loses lambda 6e-8 of itself next to the axis, where the cosine rounds: sg_evaluate_near does not.
real sg_evaluate(real lambda, real cos_theta)
{
    return exp(lambda * (cos_theta - K(1.0)));
}
