#version 450
#extension GL_GOOGLE_include_directive : require
// additional_lobe.comp: additional samples, lights without shadow taken as lobes.
#define MULTIRES_LOBES
#include "additional.glsl"
