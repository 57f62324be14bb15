#version 450
#extension GL_GOOGLE_include_directive : require
// deposit.comp: see deposit.glsl.
#include "deposit.glsl"
