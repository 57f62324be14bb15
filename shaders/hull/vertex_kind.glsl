// vertex_kind.glsl: what a vertex keeps: moments of the radiance, or with VERTEX_LOBES lobes.
#include "moments.glsl"
#ifdef VERTEX_LOBES
#include "vertex_lobe.glsl"
#else
#include "vertex.glsl"
#endif
