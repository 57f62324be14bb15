#version 450
#extension GL_GOOGLE_include_directive : require
// hull.vert: see hull_vert.glsl.
#include "hull_vert.glsl"
