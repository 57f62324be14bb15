// near.glsl: bounds of blocks of pixels, and lists of the lights that may be near to them.
#ifndef NEAR_GLSL
#define NEAR_GLSL

const int BLOCK = 8;        // pixels a side
const int ACROSS = 4;       // blocks along the side of a tile, for which lights are culled first
const uint MOST_NEAR = 64u; // lights in a block's list, and
const uint MOST_TILE = 255u; // in a tile's; with more the tree is descended again

struct Bounds {
    vec4 low;  // w: greatest view depth, 0: there is no surface
    vec4 high;
};

// Could any light below the node be near to a point within the bounds?
bool may_be_near(Node node, Bounds b, float mean_irradiance)
{
    vec3 middle = node.middle.xyz, axis = node.axis.xyz;
    float d = distance(middle, clamp(middle, b.low.xyz, b.high.xyz));
    d = max(d - node.reach, 1e-6); // no less than from the disc
    // and is any point in front of any of them?
    vec3 front = mix(b.low.xyz, b.high.xyz, greaterThan(axis, vec3(0.0))) - middle;
    vec3 farthest = max(abs(b.low.xyz - middle), abs(b.high.xyz - middle));
    float up = dot(front, axis) + node.slack + node.spread * length(farthest);
    return any_near(node, d, b.low.w, mean_irradiance) && up >= light_closest;
}

#endif
