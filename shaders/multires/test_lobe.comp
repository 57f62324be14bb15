#version 450
#extension GL_GOOGLE_include_directive : require
// test_lobe.comp: sub-fragment visibility tests, lights without shadow taken as lobes.
#define MULTIRES_LOBES
#include "test.glsl"
