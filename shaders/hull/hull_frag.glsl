// hull_frag.glsl: the far light at the pixels that the quad's component owns; or with
// HULL_PIXEL(vertex, x, n) what that makes of them.
#include "../common/frame.glsl"
#include "vertex_kind.glsl"

layout(set = 0, binding = 3) uniform sampler2D position_image;
layout(set = 0, binding = 4) uniform usampler2D normal_image;
layout(set = 0, binding = 5, std430) readonly buffer Masks
{
    uint masks[];
};

layout(location = 0) noperspective in Vertex vertex;
layout(location = VERTEX_VECTORS) flat in uint component;

layout(location = 0) out vec4 target;

#ifndef HULL_PIXEL
#define HULL_PIXEL(vertex, x, n) vec4(max(vertex_irradiance(vertex, x, n), 0.0), 1.0)
#endif

void main()
{
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    if ((masks[component * 32u + (pixel.y & 31u)] >> (pixel.x & 31u) & 1u) == 0u)
        discard;
    vec3 x = texelFetch(position_image, ivec2(pixel), 0).xyz;
    vec3 n = unpack_normal(texelFetch(normal_image, ivec2(pixel), 0).x);
    target = HULL_PIXEL(vertex, x, n);
}
