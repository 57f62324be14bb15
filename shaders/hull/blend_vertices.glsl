// blend_vertices.glsl: the new vertices of a level, see blend.glsl.
#include "blend.glsl"
#include "vertex_kind.glsl"

layout(set = 0, binding = 6, std430) buffer Vertices
{
    Vertex vertices[];
};

void main()
{
    Part part = take_part();
    if (part.key == 0u || part.own >= 1.0 || atomicCompSwap(shares[part.slot], part.key, 0u) != part.key)
        return;
    // the parent's fan there: its centre, and the corners at both ends of the nearest side
    vec2 p = part.place;
    bool upright = abs(p.x) > abs(p.y);
    float out_there = upright ? abs(p.x) : abs(p.y);
    float along = out_there > 0.0 ? (upright ? p.y : p.x) / out_there : 0.0;
    uint from = upright ? (p.x > 0.0 ? 1u : 0u) : (p.y > 0.0 ? 2u : 0u), to = from + (upright ? 2u : 1u);
    float other = 1.0 - part.own;
    Vertex v = vertex_zero();
    vertex_add(v, part.own, vertices[part.slot]);
    vertex_add(v, other * (1.0 - out_there), vertices[vertex_slot(quads[part.parent].centre, part.even)]);
    vertex_add(v, other * out_there * (0.5 - 0.5 * along), vertices[vertex_slot(quads[part.parent].corners[from], part.even)]);
    vertex_add(v, other * out_there * (0.5 + 0.5 * along), vertices[vertex_slot(quads[part.parent].corners[to], part.even)]);
    vertices[part.slot] = v;
}
