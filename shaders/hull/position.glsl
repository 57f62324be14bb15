// position.glsl: where a corner of a triangle is drawn. Needs ../common/frame.glsl.
#ifndef POSITION_GLSL
#define POSITION_GLSL

// The centre of a pixel, x + y * 65536. Quads reach beyond the image; the viewport (hull_passes.c) does so
// as well, since lavapipe clips a whole batch of triangles by its slow way if one of them needs it. A power
// of 2, so that nothing is rounded.
vec4 hull_position(uint pixel)
{
    vec2 viewport = vec2(max(uvec2(4096u), uvec2(1u) << findMSB(2u * view.size.xy - 1u)));
    return vec4((2.0 * vec2(pixel & 0xffffu, pixel >> 16) + 1.0) / viewport - 1.0, 0.0, 1.0);
}

#endif
