// likeness.glsl: how far a sample may stand for a pixel.
#ifndef LIKENESS_GLSL
#define LIKENESS_GLSL

// off: distance between the planes, in units of `plane` blocks; along: cosine between the normals. exp(-power (1 - cos))
// is close to the usual cos^power and needs one exponential together with that of the distance.
float sample_likeness(float off, float along)
{
    return exp2(-1.442695 * (off * off + power * max(1.0 - along, 0.0)));
}

#endif
