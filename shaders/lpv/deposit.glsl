// deposit.glsl: what the samples give back, into their voxels: one voxel an invocation, its list in
// a fixed order, so that sums come out the same run after run.
#include "samples.glsl"
#include "volume.glsl"

layout(local_size_x = 64) in;

struct Entry {
    uint side; // 2 * sample + side
    float area;
};
layout(set = 0, binding = 0, std430) readonly buffer Samples { LpvSample samples[]; };
layout(set = 0, binding = 1, std430) readonly buffer Reflected { vec4 reflected[]; };
layout(set = 0, binding = 2, std430) readonly buffer First { uint first[]; };
layout(set = 0, binding = 3, std430) readonly buffer Entries { Entry entries[]; };
layout(set = 0, binding = 4, std430) writeonly buffer Out { Lobes lobes[]; };
layout(set = 0, binding = 5, std430) writeonly buffer Sums { Passed sums[]; };

void main()
{
    uint voxel = gl_GlobalInvocationID.x;
    if (voxel >= voxels)
        return;
    Harmonics light = Harmonics(vec4(0.0), vec4(0.0), vec4(0.0));
    for (uint i = first[voxel]; i < first[voxel + 1u]; i++) {
        Entry entry = entries[i];
        vec3 flux = entry.area * reflected[entry.side].rgb;
        // a surface that reflects evenly: the mean direction of its light is 2/3 of the normal
        vec3 along = 2.0 / 3.0 * samples[entry.side / 2u].normal.xyz;
        vec4 unit = harmonics_of((entry.side & 1u) == 0u ? along : -along, 1.0);
        light.red += flux.r * unit;
        light.green += flux.g * unit;
        light.blue += flux.b * unit;
    }
    lobes[voxel] = lobes_of(light);
    for (uint i = 0u; i < 6u; i++)
        sums[voxel].by[i] = vec4(0.0);
}
