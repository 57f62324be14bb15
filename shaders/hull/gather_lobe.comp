#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// gather_lobe.comp: see gather.glsl; lobes are all that a vertex keeps.
#define VERTEX_LOBES
#include "gather.glsl"
