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
    for (uint at = inside ? 0u : nodes_end; at < nodes_end;) {
        uint count = find_lights(at, x, place.w, mean, done);
        done += count;
        for (uint i = 0u; i < count; i++) {
            Light l = node_light(found[i]);
            vec3 window_gradient;
            float far = 1.0 - near_weight(l, x, place.w, mean, window_gradient);
            if (!is_leaf(found[i])) { // what stands for many is far
                far = 1.0;
                window_gradient = vec3(0.0);
            }
            far = dot(x - l.a.xyz, l.plane.xyz) < light_closest ? 0.0 : far;
            float f = form_factor(l, x, n);
            vec3 g = far * form_factor_gradient(l, x, n) - f * window_gradient;
            vec3 e = light_exitance(l);
            exact += e * (far * f);
#ifdef VERTEX_LOBES
            vertex_take(v, e, far, light_moments(l, x));
#else
            vertex_take(v, e, far, light_moments(l, x), light_fourth(l, x));
#endif
            v.gradient0.xyz += e.r * g;
            v.gradient1.xyz += e.g * g;
            v.gradient2.xyz += e.b * g;
        }
    }
    vertex_finish(v, x);
    vertex_local(v, exact - vertex_irradiance(v, x, n));
    if (inside)
        vertices[slot] = v;
    counter_add_group(COUNT_EVALUATIONS, done);
}
