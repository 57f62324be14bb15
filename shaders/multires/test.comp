#version 450
#extension GL_GOOGLE_include_directive : require
// test.comp: sub-fragment visibility tests.
#include "test.glsl"
