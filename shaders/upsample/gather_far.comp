#version 450
#extension GL_GOOGLE_include_directive : require
// gather_far.comp: see gather_far.glsl.
#include "gather_far.glsl"
