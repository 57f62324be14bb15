// hull.glsl: what the passes of the hull share.
//
// The image is cut into tiles of 32 x 32 pixels, each tile into components of pixels that are
// linked (links.comp, components.comp). A component starts as one quad around it; a quad is a fan of
// triangles around its centre. Every vertex is a pixel of its component, the nearest one to where
// the quad wants it, so that quads share vertices and nothing is interpolated that was not lit.
// Where the four corners do not predict the centre, the quad is split in four (split.comp).
#ifndef HULL_GLSL
#define HULL_GLSL

const int TILE = 32;
const int ROWS = 4; // of a tile that are read together, see links.comp
const uint MOST_COMPONENTS = 64u; // in a tile; the pixels of more are lit exactly
const uint SMALL_COMPONENT = 1u;  // as many pixels or fewer are lit exactly
const uint LEVELS = 4u;           // how often quads are split, at most, plus 1
const int STEP = 4;               // pixels; sides of quads are multiples of it
const int ONE_VERTEX = 8;         // components no longer than this have one vertex along it
const float FLAT = 0.05;          // with an error below this, of that which splits it, a quad does
const uint FLAT_BIT = 0x8000u;    // without its centre; noted in its size
const uint EVEN_BIT = 0x4000u;    // there as well: its component has one normal all over
const uint EXACT_BIT = 0x10000000u; // there too: too small for parts, it errs too much: lit exactly
const uint RANKS = 16u;           // by which is chosen what finds room, see share_room
const uint NONE = 0xffffffffu;

layout(push_constant) uniform Push
{
    uint tiles_x, tiles_y;
    uint level;           // of the quads that are split next; LEVELS: there are no more
    uint vertex_capacity, corner_capacity;
    uint quad_first[5];   // of each level in the list of quads, and past the last one
    float link_plane;     // how far from its neighbour's plane a pixel may be, over its depth
    float link_cosine;    // of their normals, at least
    float split;          // error at the centre, over the mean irradiance, that splits a quad
    float tau, tau_width; // see window.glsl
    float near_pixels;
    // the same split with upsampling, see upsample/far.glsl
    uint factor, blocks_x, blocks_y;
    float plane, power, least;
    uint has_even; // are components with one normal all over lit and drawn by themselves?
    // the tree over the lights, see tree.glsl
    uint nodes_end;       // how many nodes it has
    float merge;          // error of one light for many, over the mean irradiance, at most
};

struct Quad {
    uint component; // NONE: lit exactly
    uint origin;   // x + y * 65536: its first pixel
    uint size;     // width + 256 rank + height * 65536 + 2^24 (which of its four parts to make), and bits
    uint centre;   // pixels, x + y * 65536
    uvec4 corners; // left top, right top, left bottom, right bottom
    uint parent;   // the quad that it is a part of; of level 0: nothing
    float own;     // see blend.glsl: how much of their own its parts' new vertices have, 0 to 1
};

uint pack_pixel(ivec2 p)
{
    return uint(p.x) | uint(p.y) << 16;
}

ivec2 unpack_pixel(uint p)
{
    return ivec2(p & 0xffffu, p >> 16);
}

ivec2 unpack_size(uint size)
{
    return ivec2(size & 0x3fu, size >> 16 & 0x3fu);
}

uint unpack_rank(uint size)
{
    return size >> 8 & 0xfu;
}

// Of the four parts of a quad: the size of the first, and of each.
ivec2 first_part(ivec2 size)
{
    return (size / 2 + STEP - 1) / STEP * STEP;
}

ivec2 part_size(ivec2 size, ivec2 part)
{
    return mix(first_part(size), size - first_part(size), equal(part, ivec2(1)));
}

// Where a component's tile begins.
ivec2 tile_origin(uint component)
{
    uint tile = component / MOST_COMPONENTS;
    return TILE * ivec2(tile % tiles_x, tile / tiles_x);
}

#endif
