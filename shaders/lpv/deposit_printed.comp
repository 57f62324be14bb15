#version 450
#extension GL_GOOGLE_include_directive : require
// deposit_printed.comp: deposit.glsl for printed.comp.
#define LPV_PRINTED
#include "deposit.glsl"
