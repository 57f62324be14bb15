#version 450
#extension GL_GOOGLE_include_directive : require
// additional.comp: additional samples.
#include "additional.glsl"
