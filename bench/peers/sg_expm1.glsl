// By the logarithm of the rounded exponential (Higham, Accuracy and Stability of Numerical Algorithms, 1.14.1).
float sg_expm1(float x)
{
    float u = exp(x);
    float y = u - 1.0;
    return u == 1.0 ? x : abs(x) < 1.0 ? y * x / log(u) : y;
}
