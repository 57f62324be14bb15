// map.glsl: where a pixel's vertices are. Needs control.glsl and the buffers Map and EvenMap.
//
// Where a component has one normal all over its vertices know the light at that normal alone, and
// no other component shares them: they have a map of their own, and lie at the end of the list.
#ifndef MAP_GLSL
#define MAP_GLSL

uint map_index(uint pixel)
{
    return (pixel >> 16) * view.size.x + (pixel & 0xffffu);
}

bool is_even(Quad q)
{
    return (q.size & EVEN_BIT) != 0u;
}

// Place in the list of the vertex that quads of this kind have at a pixel; NONE where there is none.
uint vertex_slot(uint pixel, bool even)
{
    uint at = map_index(pixel);
    return (even ? even_map[at] : map[at]) - 1u;
}

// Is it one of those that this level has made?
bool is_new(uint slot)
{
    return slot < gather_end ? slot >= gather_first : vertex_capacity - 1u - slot >= even_gather_first;
}

#endif
