#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// gather_sh.comp: see gather_far.glsl; of all lights.
#define ALL_LIGHTS
#include "gather_far.glsl"
