#version 450
#extension GL_GOOGLE_include_directive : require
// quads.comp: visibility tests of fragments of four pixels, which share what they see.
#define MULTIRES_QUADS
#include "test.glsl"
