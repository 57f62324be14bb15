#version 450
#extension GL_GOOGLE_include_directive : require
// propagate.comp: see propagate.glsl.
#include "propagate.glsl"
