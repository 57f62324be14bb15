// four.glsl: every light at every place of a grid: pixels, or samples of a coarser one. The shader that
// includes it says where places are and what becomes of them,
//
//     bool read_place(uvec2 place, out vec3 x, out vec3 n);   // false: no surface there, or outside
//     void write_place(uvec2 place, bool surface, vec3 irradiance);
//
// and may define FORM_FACTOR(light, x, n) for lights that cross the horizon.
//
// A work group has a tile of 16 x 16 places, four an invocation, so that what is read of a light
// serves four times. Bounds of the tile's positions and normals sort the lights, a few at a time:
// those that no place gets anything from, those above every place's horizon, which need no clip,
// and the others. The sorting changes no result, and every pair counts as one evaluation.
#include "open_form_factor.glsl"
#include "tile.glsl"

#ifndef FORM_FACTOR
#define FORM_FACTOR form_factor
#endif

layout(local_size_x = 8, local_size_y = 8) in;

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
    uvec2 places[4];
    vec3 x[4], n[4], sum[4];
    bool surface[4];
    start_bounds();
    for (int k = 0; k < 4; k++) {
        places[k] = 16u * gl_WorkGroupID.xy + gl_LocalInvocationID.xy + 8u * uvec2(k & 1, k >> 1);
        surface[k] = read_place(places[k], x[k], n[k]);
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
        write_place(places[k], surface[k], sum[k]);
    counter_add_group(COUNT_EVALUATIONS, done);
}
