#version 450
#extension GL_GOOGLE_include_directive : require
// quads_lobe.comp: the same, lights without shadow taken as lobes.
#define MULTIRES_LOBES
#define MULTIRES_QUADS
#include "test.glsl"
