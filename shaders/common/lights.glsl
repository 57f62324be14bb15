// lights.glsl: what shines: triangles that emit the same radiance in every direction of one side.
#ifndef LIGHTS_GLSL
#define LIGHTS_GLSL

struct Light {
    vec4 a, b, c; // corners, counter-clockwise seen from the side that emits;
                  // w: exitance red, green, blue (W/m^2)
    vec4 plane;   // unit normal towards that side; w: area (m^2)
};

// A point less than this (m) in front of a light's plane gets nothing from it. In small scenes the
// renderer gives another, in proportion to their size.
layout(constant_id = 0) const float light_closest = 0.002;

vec3 light_exitance(Light l)
{
    return vec3(l.a.w, l.b.w, l.c.w);
}

#ifndef LIGHTS_BINDING
#define LIGHTS_BINDING 1
#endif

// As many lights as a shader reads; declared here unless it says LIGHTS_UNBOUND.
#ifndef LIGHTS_UNBOUND
layout(set = 0, binding = LIGHTS_BINDING, std430) readonly buffer Lights
{
    Light lights[];
};
#endif

#endif
