// gather.glsl: the far light at the new vertices, TOGETHER an invocation: each finds its lights in
// the tree, some at a time.
#define TOGETHER 4
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "descent.glsl"
#include "../common/form_factor.glsl"
#include "moments.glsl"
#include "vertex_kind.glsl"
#include "tilted.glsl"

layout(local_size_x = 16) in; // with TOGETHER 64 vertices

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
#ifdef VERTEX_LOBES
layout(set = 0, binding = 8, std430) writeonly buffer Tilted
{
    vec4 tilted[]; // see fit_lobe.comp
};
#endif

// The vertices of this level: which of the list.
#ifdef VERTEX_EVEN
#define GATHER_FIRST even_gather_first
#define GATHER_END even_gather_end
#define GATHER_SLOT(i) (vertex_capacity - 1u - (i))
#else
#define GATHER_FIRST gather_first
#define GATHER_END gather_end
#define GATHER_SLOT(i) (i)
#endif

// Takes the share far of a light of exitance e into the vertex, and into the irradiance at its normal.
void take(inout Vertex v, inout vec3 exact, vec3 e, float far, float form_factor, vec3 gradient,
          Moments m, Fourth f)
{
    exact += e * (far * form_factor);
#if defined(VERTEX_LOBES)
    vertex_take(v, e, far, m);
#elif !defined(VERTEX_EVEN)
    vertex_take(v, e, far, m, f);
#endif
    v.gradient0.xyz += e.r * gradient;
    v.gradient1.xyz += e.g * gradient;
    v.gradient2.xyz += e.b * gradient;
}

void main()
{
    uint first = GATHER_FIRST + TOGETHER * gl_GlobalInvocationID.x, done = 0u;
    Seeker seekers[TOGETHER];
    vec3 normals[TOGETHER], exact[TOGETHER];
    vec4 tilt[TOGETHER]; // with VERTEX_LOBES alone
    Vertex v[TOGETHER];
    [[unroll]] for (int k = 0; k < TOGETHER; k++) {
        bool inside = first + uint(k) < GATHER_END;
        ivec2 pixel = unpack_pixel(inside ? vertex_pixels[GATHER_SLOT(first + uint(k))] : 0u);
        vec4 place = texelFetch(position_image, pixel, 0);
        uvec2 packed = texelFetch(normal_image, pixel, 0).xy;
#ifdef VERTEX_EVEN
        normals[k] = unpack_normal(packed.x);
#else
        normals[k] = vertex_normal(packed);
#endif
        seekers[k] = Seeker(place.xyz, place.w, inside ? 0u : nodes_end);
        exact[k] = vec3(0.0);
        tilt[k] = vec4(0.0);
        v[k] = vertex_zero();
    }
    // lavapipe ends a loop one round after its last invocation, unless the test comes last
    uint at = 0u;
    if (first < GATHER_END && nodes_end > 0u)
        do {
            find_lights(at, seekers, mean, done);
            uint i = 0u;
            if (found_far_count > 0u)
                do {
                    Light l = node_light(found_far[i] & FOUND_NODES);
                    vec3 e = light_exitance(l);
                    [[unroll]] for (int k = 0; k < TOGETHER; k++) {
                        FarLight s = far_light(l, seekers[k].x, normals[k]);
                        bool own = is_found_for(found_far[i], k);
                        vec3 own_e = own ? e : vec3(0.0);
                        done += own ? 1u : 0u;
                        take(v[k], exact[k], own_e, 1.0, s.form_factor, s.gradient, s.moments, s.fourth);
#ifdef VERTEX_LOBES
                        tilt[k] += (own_e.r + own_e.g + own_e.b) / 3.0 * tilted_far(l, seekers[k].x, normals[k], s.moments);
#endif
                    }
                } while (++i < found_far_count);
            i = 0u;
            if (found_near_count > 0u)
                do {
                    uint which = found_near[i] & FOUND_NODES;
                    Light l = node_light(which);
                    vec3 e = light_exitance(l);
                    bool leaf = is_leaf(which);
                    [[unroll]] for (int k = 0; k < TOGETHER; k++) {
                        vec3 x = seekers[k].x, window_gradient;
                        float far = far_share(l, leaf, x, seekers[k].depth, mean, window_gradient);
                        far = dot(x - l.a.xyz, l.plane.xyz) < light_closest ? 0.0 : far;
                        float f = form_factor(l, x, normals[k]);
                        FarLight s = far_light(l, x, normals[k]);
                        Moments m = light_moments(l, x);
                        vec3 own_e = is_found_for(found_near[i], k) ? e : vec3(0.0);
                        done += is_found_for(found_near[i], k) ? 1u : 0u;
                        take(v[k], exact[k], own_e, far, f, far * s.gradient - f * window_gradient, m, s.fourth);
#ifdef VERTEX_LOBES
                        tilt[k] += (own_e.r + own_e.g + own_e.b) / 3.0 * far * tilted_near(l, x, normals[k]);
#endif
                    }
                } while (++i < found_near_count);
        } while (at < nodes_end);
    [[unroll]] for (int k = 0; k < TOGETHER; k++)
        if (first + uint(k) < GATHER_END) {
            vertex_finish(v[k], seekers[k].x);
            vertex_local(v[k], exact[k] - vertex_irradiance(v[k], seekers[k].x, normals[k]));
            vertices[GATHER_SLOT(first + uint(k))] = v[k];
#ifdef VERTEX_LOBES
            tilted[GATHER_SLOT(first + uint(k))] = tilt[k];
#endif
        }
    counter_add_group(COUNT_EVALUATIONS, done);
}
