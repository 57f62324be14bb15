#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// gather.comp: see gather.glsl.
#include "gather.glsl"
