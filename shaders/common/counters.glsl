// counters.glsl: what the shaders count of themselves. Before including it:
//     #define COUNTERS_BINDING 3     where the counters are bound
//     #define COUNTERS_SHARED        in a compute shader that calls counter_add_group
//     #define COUNTERS_SUBGROUP      in a shader that calls counter_add_subgroup, which starts with
//                                    #extension GL_KHR_shader_subgroup_arithmetic : require
#ifndef COUNTERS_GLSL
#define COUNTERS_GLSL

const uint COUNT_EVALUATIONS = 0u; // pairs of a point and a light
const uint COUNT_COVERED = 1u;     // pixels; these three are counted after the frame
const uint COUNT_UNCOVERED = 2u;
const uint COUNT_WRONG = 3u;
const uint COUNT_QUADS = 4u;
const uint COUNT_VERTICES = 5u;
const uint COUNT_RAYS = 6u;      // shadow rays
const uint COUNT_SAMPLES = 7u;   // places where irradiance was computed
const uint COUNT_FRAGMENTS = 8u; // of level 0, 1, ... 4: this number and the four that follow
const uint COUNT_GAVE_UP = 13u;  // rays or loops over lights that the driver ended

layout(set = 0, binding = COUNTERS_BINDING, std430) buffer CounterBuffer
{
    uint counters[]; // low and high half of each
};

// One invocation adds n.
void counter_add(uint index, uint n)
{
    uint before = atomicAdd(counters[2u * index], n);
    if (before + n < before)
        atomicAdd(counters[2u * index + 1u], 1u);
}

#ifdef COUNTERS_SHARED
shared uint counter_sum;

// Every invocation of the work group calls this, in uniform control flow, each with its own n:
// one addition to the buffer for the group.
void counter_add_group(uint index, uint n)
{
    if (gl_LocalInvocationIndex == 0u)
        counter_sum = 0u;
    barrier();
    if (n > 0u)
        atomicAdd(counter_sum, n);
    barrier();
    if (gl_LocalInvocationIndex == 0u && counter_sum > 0u)
        counter_add(index, counter_sum);
    barrier();
}
#endif

#ifdef COUNTERS_SUBGROUP
// Every invocation calls this, each with its own n: one addition to the buffer for a subgroup. No
// barrier, which on a software device costs more than the additions that it saves.
void counter_add_subgroup(uint index, uint n)
{
    uint sum = subgroupAdd(n);
    if (subgroupElect() && sum > 0u)
        counter_add(index, sum);
}
#endif

#endif
