#version 450
#extension GL_GOOGLE_include_directive : require
// share.comp: which quad a new vertex follows, see blend.glsl.
#include "blend.glsl"

void main()
{
    Part part = take_part();
    if (part.key != 0u)
        atomicMax(shares[part.slot], part.key);
}
