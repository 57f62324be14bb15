#version 450
#extension GL_GOOGLE_include_directive : require
// split.comp: see split.glsl.
#include "split.glsl"
