// vertex_kind.glsl: what a vertex keeps: moments of the radiance, or with VERTEX_LOBES lobes.
#ifndef VERTEX_KIND_GLSL
#define VERTEX_KIND_GLSL

#include "moments.glsl"
#ifdef VERTEX_LOBES
#include "vertex_lobe.glsl"
#else
#include "vertex.glsl"
#endif

// The normal at which a vertex is lit; both: of its pixel. What holds at a bump's own normal says
// nothing about its neighbours.
vec3 vertex_normal(uvec2 both)
{
    vec3 n = unpack_normal(both.x), face = unpack_normal(both.y);
    return dot(n, face) > 0.97 ? n : face;
}

#endif
