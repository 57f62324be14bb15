#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// gather_even.comp: see gather.glsl; for vertices of components with one normal all over.
#define VERTEX_EVEN
#include "gather.glsl"
