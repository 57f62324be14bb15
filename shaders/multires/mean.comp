#version 450
#extension GL_GOOGLE_include_directive : require
// mean.comp: the image's mean irradiance, nearly: of a pixel of each 16 x 16, by 16 points of up to
// MEAN_LIGHTS of the lights, other ones from tile to tile. At level TOP the pixels, at 0 their mean.
#include "fragments.glsl"
#include "visibility.glsl"

layout(local_size_x = 64) in;

const uint MEAN_LIGHTS = 4u;

shared vec2 sums[64];

void look(uint tile, uint tile_count)
{
    uvec2 at = uvec2(tile % tiles.x, tile / tiles.x);
    uint lights_here = min(light_count, MEAN_LIGHTS), rays = 0u, i = 0u;
    Surface s = surface_at(ivec2(16u * at + 8u));
    vec3 sum = vec3(0.0);
    s.there = s.there && tile < tile_count;
    for (; i < lights_here; i++) {
        uint light = (tile * lights_here + i) % light_count;
        uvec2 bits;
        sum += area_irradiance(light, AREA_FEW * (tile & 3u), AREA_FEW, s, bits, rays);
    }
    trace_gave_up = trace_gave_up || i < lights_here;
    sum *= float(light_count) / float(max(lights_here, 1u));
    if (tile < tile_count)
        illumination[fragment_index(TOP, at)] =
            vec4((sum.r + sum.g + sum.b) / 3.0, s.there ? 1.0 : 0.0, 0.0, NOTHING);
    counter_add_group(COUNT_EVALUATIONS, s.there ? lights_here : 0u);
    count_rays(rays);
}

void main()
{
    uint mine = gl_LocalInvocationIndex, tile_count = tiles.x * tiles.y;
    if (level == TOP) {
        look(gl_GlobalInvocationID.x, tile_count);
        return;
    }
    vec2 sum = vec2(0.0);
    for (uint i = mine; i < tile_count; i += 64u)
        sum += illumination[level_base(TOP) + i].xy;
    sums[mine] = sum;
    barrier();
    for (uint i = 1u; i < 64u && mine == 0u; i++)
        sum += sums[i];
    if (mine == 0u)
        work[MEAN].groups[0] = floatBitsToUint(sum.x / max(sum.y, 1.0));
}
