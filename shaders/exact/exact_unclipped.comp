#version 450
#extension GL_GOOGLE_include_directive : require
// exact_unclipped.comp: the same without the clip, as many renderers have it.
#define FORM_FACTOR open_form_factor
#include "exact.glsl"
