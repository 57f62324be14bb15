#version 450
#extension GL_GOOGLE_include_directive : require
// split_lobe.comp: see split.glsl; for lobes.
#define VERTEX_LOBES
#include "split.glsl"
