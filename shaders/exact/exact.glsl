// exact.glsl: ground truth. Every pixel, every light: its form factor, clipped to the pixel's
// horizon where the light crosses it by FORM_FACTOR(light, x, n).
//
// A work group has a tile of 16 x 16 pixels, four an invocation, so that what is read of a light
// serves four times. Bounds of the tile's positions and normals sort the lights, a few at a time:
// those that no pixel gets anything from, those above every pixel's horizon, which need no clip,
// and the others. The sorting changes no result, and every pair counts as one evaluation.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "open_form_factor.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant) uniform Push
{
    uint first_row; // of this dispatch: large images are done in strips
};

layout(set = 0, binding = 3) uniform sampler2D position_image;
layout(set = 0, binding = 4) uniform usampler2D normal_image;
layout(set = 0, binding = 5, rgba32f) writeonly uniform image2D light_image;

const uint STAGE = 64u;
shared Light staged[STAGE];
shared uint kinds[STAGE], order[STAGE]; // order: those that are open first
shared uint open_count, all_count;
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

// Reads the lights from first on, sorted; all invocations.
void stage(uint first, uint count)
{
    uint i = gl_LocalInvocationIndex;
    barrier();
    kinds[i] = NOTHING;
    if (first + i < count) {
        staged[i] = lights[first + i];
        kinds[i] = kind_of(staged[i], tile_bounds());
    }
    barrier();
    if (i == 0u) {
        uint place = 0u;
        for (uint light = 0u; light < STAGE; light++)
            if (kinds[light] == OPEN)
                order[place++] = light;
        open_count = place;
        for (uint light = 0u; light < STAGE; light++)
            if (kinds[light] == CROSSING)
                order[place++] = light;
        all_count = place;
    }
    barrier();
}

void main()
{
    uint count = view.size.z, done = 0u;
    ivec2 pixels[4];
    vec3 x[4], n[4], sum[4];
    bool surface[4];
    if (gl_LocalInvocationIndex < 6u) {
        lowest[gl_LocalInvocationIndex] = 0xffffffffu;
        highest[gl_LocalInvocationIndex] = 0u;
    }
    barrier();
    for (int k = 0; k < 4; k++) {
        uvec2 at = 16u * gl_WorkGroupID.xy + gl_LocalInvocationID.xy + 8u * uvec2(k & 1, k >> 1);
        at.y += first_row;
        pixels[k] = ivec2(at);
        bool inside = all(lessThan(at, view.size.xy));
        vec4 position = inside ? texelFetch(position_image, pixels[k], 0) : vec4(0.0);
        surface[k] = position.w > 0.0;
        x[k] = position.xyz;
        n[k] = surface[k] ? unpack_normal(texelFetch(normal_image, pixels[k], 0).x) : vec3(0.0);
        sum[k] = vec3(0.0);
        done += surface[k] ? count : 0u;
        if (surface[k])
            bound(x[k], n[k]);
    }
    // by hand, not in a loop over k: with fixed indices the arrays stay in registers
    barrier();
    uint needed = lowest[0] <= highest[0] ? count : 0u; // none where no pixel has a surface
    for (uint first = 0u; first < needed; first += STAGE) {
        stage(first, count);
        for (uint i = 0u; i < open_count; i++) {
            Light l = staged[order[i]];
            vec3 exitance = light_exitance(l);
            sum[0] += exitance * open_form_factor(l, x[0], n[0]);
            sum[1] += exitance * open_form_factor(l, x[1], n[1]);
            sum[2] += exitance * open_form_factor(l, x[2], n[2]);
            sum[3] += exitance * open_form_factor(l, x[3], n[3]);
        }
        for (uint i = open_count; i < all_count; i++) {
            Light l = staged[order[i]];
            vec3 exitance = light_exitance(l);
            sum[0] += exitance * FORM_FACTOR(l, x[0], n[0]);
            sum[1] += exitance * FORM_FACTOR(l, x[1], n[1]);
            sum[2] += exitance * FORM_FACTOR(l, x[2], n[2]);
            sum[3] += exitance * FORM_FACTOR(l, x[3], n[3]);
        }
    }
    for (int k = 0; k < 4; k++)
        if (surface[k])
            imageStore(light_image, pixels[k], vec4(sum[k], 1.0));
    counter_add_group(COUNT_EVALUATIONS, done);
}
