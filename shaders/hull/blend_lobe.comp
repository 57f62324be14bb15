#version 450
#extension GL_GOOGLE_include_directive : require
// blend_lobe.comp: see blend.glsl; for lobes.
#define VERTEX_LOBES
#include "blend_vertices.glsl"
