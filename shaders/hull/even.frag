#version 450
// even.frag: as hull_frag.glsl for quads with one normal all over, see even.vert.

layout(set = 0, binding = 3) uniform sampler2D position_image;
layout(set = 0, binding = 5, std430) readonly buffer Masks
{
    uint masks[];
};

layout(location = 0) noperspective in vec3 place;
layout(location = 1) noperspective in vec4 gradients[3];
layout(location = 4) flat in uint component;

layout(location = 0) out vec4 target;

void main()
{
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    if ((masks[component * 32u + (pixel.y & 31u)] >> (pixel.x & 31u) & 1u) == 0u)
        discard;
    vec4 d = vec4(texelFetch(position_image, ivec2(pixel), 0).xyz - place, 1.0);
    vec3 e = vec3(dot(gradients[0], d), dot(gradients[1], d), dot(gradients[2], d));
    target = vec4(max(e, 0.0), 1.0);
}
