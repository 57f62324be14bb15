#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// gather_far.comp: see gather_far.glsl.
#include "gather_far.glsl"
