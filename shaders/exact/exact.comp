#version 450
#extension GL_GOOGLE_include_directive : require
// exact.comp: ground truth, clipped to the horizon of each pixel.
#define FORM_FACTOR form_factor
#include "exact.glsl"
