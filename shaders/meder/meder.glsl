// meder.glsl: what the passes of the pipeline `meder` share: Meder and Bruederlin, Screen Space
// Approximate Gaussian Hulls, section 3, as printed.
#ifndef MEDER_GLSL
#define MEDER_GLSL

const uint SIDE = 1024u;        // of the downsampled depth, in texels
const uint TILE = 32u;          // of a tile, in texels
const uint TILES = SIDE / TILE; // along a side
const uint TEXELS = TILE * TILE;

// A segment's bounding box on the screen, in the numbers that atomics take.
struct Box {
    uvec2 low, high;     // texels of the downsampled depth, both included
    uint z_low, z_high;  // depth as the bits of a float: not negative, so they compare alike
    uint segment;        // tile * TEXELS + label
    uint unused;
};

// The texel of the downsampled depth that a pixel's centre lies in, and the other way round.
ivec2 texel_of_pixel(ivec2 pixel, uvec2 size)
{
    return ivec2((2u * uvec2(pixel) + 1u) * SIDE / (2u * size));
}

ivec2 pixel_of_texel(ivec2 texel, uvec2 size)
{
    return ivec2((2u * uvec2(texel) + 1u) * size / (2u * SIDE));
}

uint tile_of_texel(ivec2 texel)
{
    return uint(texel.y) / TILE * TILES + uint(texel.x) / TILE;
}

#endif
