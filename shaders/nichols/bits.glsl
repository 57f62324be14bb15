// bits.glsl: the 64 bits of visibility that are kept for each fragment and light.
#ifndef BITS_GLSL
#define BITS_GLSL

layout(set = 0, binding = 13, std430) buffer Visible
{
    uvec2 visible[]; // a fragment: x: 1 if it was traced; then the bits of each light
};

#endif
