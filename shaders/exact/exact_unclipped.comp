#version 450
#extension GL_GOOGLE_include_directive : require
// exact_unclipped.comp: the same without the clip, as many renderers have it.
#define FORM_FACTOR form_factor_unclipped
#include "exact.glsl"
