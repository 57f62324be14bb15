#version 450
#extension GL_GOOGLE_include_directive : require
// blend.comp: see blend.glsl.
#include "blend_vertices.glsl"
