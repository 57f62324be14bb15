#version 450
#extension GL_GOOGLE_include_directive : require
// cull.comp: geometric discontinuity and light culling (3.1.1). The coarsest fragments without a
// discontinuity are to be tested; of those that face away from every light all is known. Where
// even four pixels differ, those are fragments of their own. An invocation does a fragment of
// level 1, and those above it of which it is the first.
#include "fragments.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// A light reaches above the surface, and the surface is in front of the light.
bool faces(Surface s, uint light)
{
    uvec4 range = areas[light].range;
    float highest = 0.0;
    for (uint i = range.x; i < range.x + range.y; i++)
        highest = max(max(highest, dot(lights[i].a.xyz - s.position, s.normal)),
                      max(dot(lights[i].b.xyz - s.position, s.normal),
                          dot(lights[i].c.xyz - s.position, s.normal)));
    return highest > 0.0 && dot(s.position - lights[range.x].a.xyz, areas[light].plane.xyz) > 0.0;
}

// At the middles of the four sub-fragments and at the corners.
bool faces_any(uint l, uvec2 at)
{
    int width = 1 << l, h = width / 2;
    ivec2 first = ivec2(at << l);
    for (int i = 0; i < 8; i++) {
        ivec2 side = ivec2(i & 1, i >> 1 & 1);
        ivec2 pixel = first + (i < 4 ? side * h + h / 2 : side * (width - 1));
        Surface s = surface_at(pixel);
        for (uint light = 0u; s.there && light < light_count; light++)
            if (faces(s, light))
                return true;
    }
    return false;
}

void main()
{
    uvec2 at = gl_GlobalInvocationID.xy;
    bool inside = all(lessThan(at, tiles * 8u));
    uint dark[5] = uint[5](0u, 0u, 0u, 0u, 0u);
    uint l = TOP;
    while (inside && l > 1u && pyramid[pyramid_index(l, at >> (l - 1u))] > 1.0)
        l--;
    float value = inside ? pyramid[pyramid_index(l, at >> (l - 1u))] : -1.0;
    bool first = all(equal(at & ((1u << (l - 1u)) - 1u), uvec2(0u)));
    if (value >= 0.0 && first) {
        uvec2 fragment = at >> (l - 1u);
        bool split = value > 1.0;
        if (faces_any(l, fragment)) {
            push_fragment(l, pack_fragment(fragment, split ? FORCED : 0u));
        } else {
            illumination[fragment_index(l, fragment)] = vec4(vec3(0.0), DARK);
            dark[l] = 1u;
        }
    }
    for (uint i = 1u; i <= TOP; i++)
        counter_add_group(COUNT_FRAGMENTS + i, dark[i]);
}
