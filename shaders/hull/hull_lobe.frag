#version 450
#extension GL_GOOGLE_include_directive : require
// hull_lobe.frag: see hull_frag.glsl; for lobes.
#define VERTEX_LOBES
#include "hull_frag.glsl"
