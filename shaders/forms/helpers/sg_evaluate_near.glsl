// sg_evaluate_near: a lobe of amplitude 1 in a direction, in [0, 1], from |direction - axis|^2 in [0, 4].
// That square is 2 - 2 cos theta, and does not round to 0 next to the axis.
real sg_evaluate_near(real lambda, real difference_squared)
{
    return exp(K(-0.5) * lambda * difference_squared);
}
