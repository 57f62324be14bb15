// near.glsl: bounds of blocks of pixels, and lists of the lights that may be near to them.
#ifndef NEAR_GLSL
#define NEAR_GLSL

const int BLOCK = 8;        // pixels a side
const int ACROSS = 4;       // blocks along the side of a tile, for which lights are culled first
const uint MOST_NEAR = 64u; // lights in a block's list; with more the tile's is taken

struct Bounds {
    vec4 low;  // w: greatest view depth, 0: there is no surface
    vec4 high;
};

// Could the light be near to a point within the bounds?
bool may_be_near(Light l, Bounds b, float mean_irradiance)
{
    vec3 middle = (l.a.xyz + l.b.xyz + l.c.xyz) * (1.0 / 3.0);
    float d = distance(middle, clamp(middle, b.low.xyz, b.high.xyz));
    d = max(d - sqrt(l.plane.w * (1.0 / PI)), 1e-6); // no less than from the disc
    vec3 normal = l.plane.xyz; // and is any of it in front?
    vec3 front = mix(b.low.xyz, b.high.xyz, greaterThan(normal, vec3(0.0)));
    float error = near_error(l, d * d, b.low.w, mean_irradiance);
    return window_place(error) > 0.0 && dot(front - l.a.xyz, normal) >= light_closest;
}

#endif
