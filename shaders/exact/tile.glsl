// tile.glsl: bounds of the positions and normals of a work group's pixels, and what they tell of a
// light.
#ifndef TILE_GLSL
#define TILE_GLSL

#include "../common/lights.glsl"

shared uint lowest[6], highest[6]; // position and normal, see rising()

const uint NOTHING = 0u, OPEN = 1u, CROSSING = 2u;

// Unsigned numbers in the order of the floats.
uint rising(float x)
{
    uint bits = floatBitsToUint(x);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float falling_back(uint x)
{
    return uintBitsToFloat((x & 0x80000000u) != 0u ? x & 0x7fffffffu : ~x);
}

// Before the first bound(); all invocations.
void start_bounds()
{
    if (gl_LocalInvocationIndex < 6u) {
        lowest[gl_LocalInvocationIndex] = 0xffffffffu;
        highest[gl_LocalInvocationIndex] = 0u;
    }
    barrier();
}

bool is_tile_empty()
{
    return lowest[0] > highest[0];
}

void bound(vec3 position, vec3 normal)
{
    for (int i = 0; i < 3; i++) {
        atomicMin(lowest[i], rising(position[i]));
        atomicMax(highest[i], rising(position[i]));
        atomicMin(lowest[3 + i], rising(normal[i]));
        atomicMax(highest[3 + i], rising(normal[i]));
    }
}

struct Bounds {
    vec3 x_low, x_high, n_low, n_high;
};

Bounds tile_bounds()
{
    Bounds b;
    for (int i = 0; i < 3; i++) {
        b.x_low[i] = falling_back(lowest[i]);
        b.x_high[i] = falling_back(highest[i]);
        b.n_low[i] = falling_back(lowest[3 + i]);
        b.n_high[i] = falling_back(highest[3 + i]);
    }
    return b;
}

// Least and greatest dot(c - x, n) over the tile.
vec2 height_range(vec3 c, Bounds b)
{
    vec3 low = c - b.x_high, high = c - b.x_low;
    vec3 p = low * b.n_low, q = low * b.n_high, r = high * b.n_low, s = high * b.n_high;
    return vec2(dot(min(min(p, q), min(r, s)), vec3(1.0)), dot(max(max(p, q), max(r, s)), vec3(1.0)));
}

uint kind_of(Light l, Bounds b)
{
    vec3 p = (b.x_low - l.a.xyz) * l.plane.xyz, q = (b.x_high - l.a.xyz) * l.plane.xyz;
    vec2 h0 = height_range(l.a.xyz, b), h1 = height_range(l.b.xyz, b), h2 = height_range(l.c.xyz, b);
    // rounding errors are far below this
    const float margin = 1e-4;
    if (dot(max(p, q), vec3(1.0)) < light_closest - margin || max(h0.y, max(h1.y, h2.y)) < -margin)
        return NOTHING;
    return min(h0.x, min(h1.x, h2.x)) > margin ? OPEN : CROSSING;
}

#endif
