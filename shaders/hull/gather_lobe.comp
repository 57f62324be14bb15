#version 450
#extension GL_GOOGLE_include_directive : require
// gather_lobe.comp: see gather.glsl; a lobe for each colour is all that a vertex keeps.
#define VERTEX_LOBES
#include "gather.glsl"
