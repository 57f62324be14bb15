// As the authors' shaders have it: the tail is lost, which they clamp away.
float sg_erfc(float x)
{
    return 1.0 - sg_erf(x);
}
