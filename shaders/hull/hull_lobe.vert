#version 450
#extension GL_GOOGLE_include_directive : require
// hull_lobe.vert: see hull_vert.glsl; for lobes.
#define VERTEX_LOBES
#include "hull_vert.glsl"
