// map.glsl: where a pixel's vertex is. Needs the buffer Map.
#ifndef MAP_GLSL
#define MAP_GLSL

uint map_index(uint pixel)
{
    return (pixel >> 16) * view.size.x + (pixel & 0xffffu);
}

// Place of a vertex in the list; NONE where there is none.
uint vertex_slot(uint pixel)
{
    return map[map_index(pixel)] - 1u;
}

#endif
