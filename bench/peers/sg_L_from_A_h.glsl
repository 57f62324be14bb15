// By the closed form of A as it stands in the papers.
float sg_L_from_A_h(float A_h, float lambda, float cos_theta)
{
    float e = exp(-lambda);
    return A_h * lambda / (6.28318530717959 * (1.0 - e * e));
}
