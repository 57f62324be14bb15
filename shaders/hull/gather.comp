#version 450
#extension GL_GOOGLE_include_directive : require
// gather.comp: see gather.glsl.
#include "gather.glsl"
