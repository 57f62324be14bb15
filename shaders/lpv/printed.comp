#version 450
#extension GL_GOOGLE_include_directive : require
// printed.comp: propagate.glsl with the lobes of Kaplanyan and Dachsbacher 2010.
#define LPV_PRINTED
#include "propagate.glsl"
