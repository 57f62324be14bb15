// control.glsl: counts that one pass leaves for the next, and the work groups that follow from them.
#ifndef CONTROL_GLSL
#define CONTROL_GLSL

#ifndef CONTROL_BINDING
#define CONTROL_BINDING 1
#endif

layout(set = 0, binding = CONTROL_BINDING, std430) buffer Control
{
    uint claim_groups[3], gather_groups[3], split_groups[3], leaf_groups[3], near_groups[3];
    uint draw_vertices, draw_instances, draw_first, draw_first_instance;
    uint even_vertices, even_instances, even_first, even_first_instance;
    uint leaf_count, near_count, vertex_count;
    uint gather_first, gather_end; // the vertices that the next gathering is for
    uint quad_count[5];            // by level
    float mean;                    // of the irradiance over the image, estimated
    // Room in a list goes to those of the highest rank, and to all of a rank or to none, so that it
    // does not depend on the order in which they come.
    uint wanted_quads[16], wanted_vertices[16]; // by rank, at most as many will be made
    uint least_rank;                            // that finds room
    uint plain_groups[3];                       // of emit.comp, where its fans found no room
    // vertices of components with one normal all over, see map.glsl
    uint even_groups[3], even_count, even_gather_first, even_gather_end;
};

#endif
