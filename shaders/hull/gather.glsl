// gather.glsl: the far light at the new vertices, one invocation a vertex: each finds its lights in
// the tree, some at a time.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "tree.glsl"
#include "../common/form_factor.glsl"
#include "moments.glsl"
#include "vertex_kind.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 4) uniform sampler2D position_image;
layout(set = 0, binding = 5) uniform usampler2D normal_image;
layout(set = 0, binding = 6, std430) readonly buffer VertexPixels
{
    uint vertex_pixels[];
};
layout(set = 0, binding = 7, std430) writeonly buffer Vertices
{
    Vertex vertices[];
};

// Takes the share far of a light of exitance e into the vertex, and into the irradiance at its normal.
void take(inout Vertex v, inout vec3 exact, vec3 e, float far, float form_factor, vec3 gradient,
          Moments m, Fourth f)
{
    exact += e * (far * form_factor);
#ifdef VERTEX_LOBES
    vertex_take(v, e, far, m);
#else
    vertex_take(v, e, far, m, f);
#endif
    v.gradient0.xyz += e.r * gradient;
    v.gradient1.xyz += e.g * gradient;
    v.gradient2.xyz += e.b * gradient;
}

void main()
{
    uint slot = gather_first + gl_GlobalInvocationID.x, done = 0u;
    bool inside = slot < gather_end;
    ivec2 pixel = unpack_pixel(inside ? vertex_pixels[slot] : 0u);
    vec4 place = texelFetch(position_image, pixel, 0);
    uvec2 normals = texelFetch(normal_image, pixel, 0).xy;
    vec3 x = place.xyz, n = unpack_normal(normals.x), face = unpack_normal(normals.y);
    // what holds at a bump's own normal says nothing about its neighbours
    n = dot(n, face) > 0.97 ? n : face;

    Vertex v = vertex_zero();
    vec3 exact = vec3(0.0);
    uint at = 0u;
    if (inside && nodes_end > 0u)
        do {
            uint others;
            uint count = find_lights(at, x, place.w, mean, done, others);
            done += count + others;
            uint i = 0u;
            if (count > 0u)
                do {
                    Light l = node_light(found[i]);
                    FarLight s = far_light(l, x, n);
                    take(v, exact, light_exitance(l), 1.0, s.form_factor, s.gradient, s.moments,
                         s.fourth);
                } while (++i < count);
            i = 0u;
            if (others > 0u)
                do {
                    uint which = found[MOST_FOUND - 1u - i];
                    Light l = node_light(which);
                    vec3 window_gradient;
                    float far = 1.0 - near_weight(l, x, place.w, mean, window_gradient);
                    if (!is_leaf(which)) { // what stands for many is far
                        far = 1.0;
                        window_gradient = vec3(0.0);
                    }
                    far = dot(x - l.a.xyz, l.plane.xyz) < light_closest ? 0.0 : far;
                    float f = form_factor(l, x, n);
                    FarLight s = far_light(l, x, n);
                    take(v, exact, light_exitance(l), far, f, far * s.gradient - f * window_gradient,
                         light_moments(l, x), s.fourth);
                } while (++i < others);
        } while (at < nodes_end);
    vertex_finish(v, x);
    vertex_local(v, exact - vertex_irradiance(v, x, n));
    if (inside)
        vertices[slot] = v;
    counter_add_group(COUNT_EVALUATIONS, done);
}
