#version 450
#extension GL_GOOGLE_include_directive : require
// pyramids.comp: depth and normal discontinuity pyramids (3.1.1). The discontinuity of a fragment
// is the most of
// - how far neighbouring pixels in it lie off each other's tangent planes, in pixels of their
//   distance, over plane_limit: a plane seen at a grazing angle is continuous;
// - the diagonal of the box around its normals, over normal_limit.
// Above 1 it is discontinuous. -1: without a surface; MIXED: with one in some pixels only.
#include "fragments.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

const float MIXED = 1e9;

shared vec4 places[256]; // position, depth
shared vec3 faces[256];
shared vec4 lows[256];   // of the normals; w: most off the planes
shared vec4 highs[256];  // of the normals; w: 1 where there is a surface
shared vec2 offs[256];   // from the pixel to the right, and to the one below

// How far two neighbouring pixels are off each other's planes.
float off_planes(uint a, uint b)
{
    vec3 d = places[b].xyz - places[a].xyz;
    float size = view.eye.w * min(places[a].w, places[b].w);
    return max(abs(dot(d, faces[a])), abs(dot(d, faces[b]))) / size;
}

// The most off between the pixels on both sides of the lines that cut a fragment in four.
float off_inside(uvec2 first, uint width)
{
    uint h = width / 2u;
    float most = 0.0;
    for (uint i = 0u; i < width; i++) {
        uint row = (first.y + i) * 16u + first.x + h, column = (first.y + h) * 16u + first.x + i;
        most = max(most, max(offs[row - 1u].x, offs[column - 16u].y));
    }
    return most;
}

void main()
{
    uint mine = gl_LocalInvocationIndex;
    uvec2 local = gl_LocalInvocationID.xy;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool inside = all(lessThan(gl_GlobalInvocationID.xy, view.size.xy));
    vec4 place = inside ? texelFetch(position_image, pixel, 0) : vec4(0.0);
    uvec2 packed = inside ? texelFetch(normal_image, pixel, 0).xy : uvec2(0u);
    bool there = place.w > 0.0;
    vec3 n = unpack_normal(packed.x);
    places[mine] = place;
    faces[mine] = unpack_normal(packed.y);
    lows[mine] = vec4(there ? n : vec3(2.0), 0.0);
    highs[mine] = vec4(there ? n : vec3(-2.0), there ? 1.0 : 0.0);
    barrier();
    offs[mine] = vec2(local.x < 15u ? off_planes(mine, mine + 1u) : 0.0,
                      local.y < 15u ? off_planes(mine, mine + 16u) : 0.0);
    barrier();
    for (uint l = 1u; l <= TOP; l++) {
        uint width = 1u << l, h = width / 2u;
        if (all(equal(local & (width - 1u), uvec2(0u)))) {
            vec4 low = lows[mine], high = highs[mine];
            float most = high.w;
            for (uint i = 1u; i < 4u; i++) {
                uint other = mine + (i & 1u) * h + (i >> 1) * h * 16u;
                low.xyz = min(low.xyz, lows[other].xyz);
                low.w = max(low.w, lows[other].w);
                high.xyz = max(high.xyz, highs[other].xyz);
                high.w = min(high.w, highs[other].w);
                most = max(most, highs[other].w);
            }
            float range = length(high.xyz - low.xyz) / normal_limit;
            bool all_there = high.w > 0.0 && low.w < MIXED;
            low.w = all_there ? max(low.w, off_inside(local, width) / plane_limit) : MIXED;
            high.w = most; // whether any pixel has a surface, from here on
            low.w = all_there ? low.w : most > 0.0 ? MIXED : 0.0;
            lows[mine] = low;
            highs[mine] = high;
            float value = most <= 0.0 ? -1.0 : max(low.w, all_there ? range : MIXED);
            pyramid[pyramid_index(l, uvec2(pixel) >> l)] = value;
        }
        barrier();
    }
}
