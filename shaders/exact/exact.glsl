// exact.glsl: ground truth. Every pixel, every light: its form factor, by FORM_FACTOR(light, x, n).
// The work group reads the lights together, a few at a time.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "../common/form_factor.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(push_constant) uniform Push
{
    uint first_row; // of this dispatch: large images are done in strips
};

layout(set = 0, binding = 3) uniform sampler2D position_image;
layout(set = 0, binding = 4) uniform usampler2D normal_image;
layout(set = 0, binding = 5, rgba32f) writeonly uniform image2D light_image;

const uint STAGE = 128u; // the size of the work group
shared Light staged[STAGE];

// As without a horizon: what lies below it counts negative.
float form_factor_unclipped(Light l, vec3 x, vec3 n)
{
    vec3 v0 = l.c.xyz - x, v1 = l.b.xyz - x, v2 = l.a.xyz - x;
    float in_front = -dot(v2, l.plane.xyz);
    vec3 sum = vec3(0.0);
    v0 = normalize(v0);
    v1 = normalize(v1);
    v2 = normalize(v2);
    vec3 g0 = cross(v0, v1), g1 = cross(v1, v2), g2 = cross(v2, v0);
    float d0 = dot(v0, v1), d1 = dot(v1, v2), d2 = dot(v2, v0);
    sum += g0 * (d0 < 0.0 ? PI * inversesqrt(max(dot(g0, g0), 1e-30)) - angle_over_sine(-d0)
                          : angle_over_sine(min(d0, 1.0)));
    sum += g1 * (d1 < 0.0 ? PI * inversesqrt(max(dot(g1, g1), 1e-30)) - angle_over_sine(-d1)
                          : angle_over_sine(min(d1, 1.0)));
    sum += g2 * (d2 < 0.0 ? PI * inversesqrt(max(dot(g2, g2), 1e-30)) - angle_over_sine(-d2)
                          : angle_over_sine(min(d2, 1.0)));
    return in_front < light_closest ? 0.0 : max(dot(sum, n), 0.0) / (2.0 * PI);
}

void main()
{
    uvec2 at = uvec2(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y + first_row);
    ivec2 pixel = ivec2(at);
    bool inside = all(lessThan(at, view.size.xy));
    vec4 position = inside ? texelFetch(position_image, pixel, 0) : vec4(0.0);
    bool surface = position.w > 0.0;
    vec3 n = surface ? unpack_normal(texelFetch(normal_image, pixel, 0).x) : vec3(0.0, 0.0, 1.0);
    vec3 irradiance = vec3(0.0);
    uint count = view.size.z, done = 0u;
    for (uint first = 0u; first < count; first += STAGE) {
        uint mine = first + gl_LocalInvocationIndex;
        if (mine < count)
            staged[gl_LocalInvocationIndex] = lights[mine];
        barrier();
        uint last = surface ? min(STAGE, count - first) : 0u;
        for (uint i = 0u; i < last; i++)
            irradiance += light_exitance(staged[i]) * FORM_FACTOR(staged[i], position.xyz, n);
        done += last;
        barrier();
    }
    if (surface)
        imageStore(light_image, pixel, vec4(irradiance, 1.0));
    counter_add_group(COUNT_EVALUATIONS, done);
}
