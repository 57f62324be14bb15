// samples.glsl: points on surfaces, as lib/render/lpv.h has them.
#ifndef SAMPLES_GLSL
#define SAMPLES_GLSL

struct LpvSample {
    vec4 position; // w: its area
    vec4 normal;   // on the side of the face normal; w: 0
    vec4 face;     // of the triangle; w: 0
    vec4 albedo;
};

#endif
