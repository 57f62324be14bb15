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
#include "tile.glsl"

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
    start_bounds();
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
    barrier();
    uint needed = is_tile_empty() ? 0u : count;
    // four lines, not a loop over k: with fixed indices the arrays stay in registers
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
