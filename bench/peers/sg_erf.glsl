// The error function of the cost class that the authors' shaders have: an odd polynomial up to 1, one less
// a power of two beyond (log2(erfc x)/x interpolated at 7 Chebyshev points of [1, 4]: absolute error 2.4e-8), 1 from 4 on.
float sg_erf(float x)
{
    float size = abs(x);
    float q = 2.0 * x * x - 1.0;
    float inner = 0.96546873867 + q * (-0.140536097278 + q * (0.0198524971409 + q * (-0.00228541954487
        + q * (0.000217513541656 + q * -1.76690680261e-05))));
    float power = size * (-1.62827628 + size * (-0.916269121 + size * (-0.153562177 + size * (0.0346717124
        + size * (-0.00548967527 + size * (0.000532588736 + size * -2.35293328e-05))))));
    float outer = size >= 4.0 ? 1.0 : 1.0 - exp2(power);
    return size > 1.0 ? (x < 0.0 ? -outer : outer) : x * inner;
}
