// block.glsl: the pixel that stands for a block of factor x factor pixels.
#ifndef BLOCK_GLSL
#define BLOCK_GLSL

// The pixel that is lit for a block: the middle one if it has a surface, else the nearest to it
// that has; w of its position is 0 where there is none.
ivec2 block_pixel(ivec2 block, sampler2D position_image, out vec4 position)
{
    ivec2 first = block * int(factor);
    ivec2 last = min(first + int(factor), ivec2(view.size.xy)) - 1;
    ivec2 middle = min(first + int(factor) / 2, last), best = middle;
    position = texelFetch(position_image, middle, 0);
    int nearest = 0x7fffffff;
    ivec2 look = position.w > 0.0 ? last + 1 : first; // one look is enough in most blocks
    for (ivec2 at = look; at.y <= last.y; at.y++)
        for (at.x = look.x; at.x <= last.x; at.x++) {
            ivec2 d = at - middle;
            int distance2 = d.x * d.x + d.y * d.y;
            if (distance2 < nearest && texelFetch(position_image, at, 0).w > 0.0) {
                nearest = distance2;
                best = at;
            }
        }
    if (nearest < 0x7fffffff)
        position = texelFetch(position_image, best, 0);
    return best;
}

// The size of a block on a surface that faces the eye at this view depth.
float block_size(float depth)
{
    return depth * view.eye.w * float(factor);
}

#endif
