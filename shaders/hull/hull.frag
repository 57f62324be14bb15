#version 450
#extension GL_GOOGLE_include_directive : require
// hull.frag: see hull_frag.glsl.
#include "hull_frag.glsl"
