// tree.glsl: the lights in a tree (lib/render/hull_tree.h), descended by every invocation on its own.
//
// Nodes come in the order of a descent, so that a descent needs no stack: to open a node is to go to
// the next one, to be done with it is to skip what is below. Leaves are lights; any other node has a
// triangle of light that may stand for all that is below where it is far enough.
#ifndef TREE_GLSL
#define TREE_GLSL

#define LIGHTS_UNBOUND
#include "../common/lights.glsl"
#include "window.glsl"

const float THREE_POINTS = 0.25; // radius over distance of a light that is integrated by three points, at most
const uint NODES_ACROSS = 256u; // in a row of their image, 8 texels each

struct Node {
    vec4 middle; // w: radius around it
    vec4 axis;   // normal of the triangle; w: flux of all that is below, mean of the colours
    float spread, bend, slack, reach, strongest, smallest;
    uint skip;
    bool leaf;
};

#ifndef TREE_BINDING
#define TREE_BINDING 1
#endif
// An image of them (lib/render/hull_tree.h): lavapipe fetches a texel as a whole, but the words of a
// buffer one by one.
layout(set = 0, binding = TREE_BINDING) uniform usampler2D tree_image;

uvec4 tree_texel(uint node, uint texel)
{
    return texelFetch(tree_image, ivec2(8u * (node % NODES_ACROSS) + texel, node / NODES_ACROSS), 0);
}

vec4 tree_vector(uint node, uint texel)
{
    return uintBitsToFloat(tree_texel(node, texel));
}

// The light itself; above the leaves the triangle that may stand for many.
Light node_light(uint node)
{
    return Light(tree_vector(node, 0u), tree_vector(node, 1u), tree_vector(node, 2u),
                 tree_vector(node, 3u));
}

Node read_node(uint node)
{
    vec4 shape = tree_vector(node, 6u);
    uvec4 last = tree_texel(node, 7u);
    vec2 light = uintBitsToFloat(last.xy);
    return Node(tree_vector(node, 4u), tree_vector(node, 5u), shape.x, shape.y, shape.z, shape.w,
                light.x, light.y, last.z, last.z == node + 1u);
}

bool is_leaf(uint node)
{
    return tree_texel(node, 7u).z == node + 1u;
}

// How much the triangle errs about, over the flux that arrives; 0 for leaves. Its centre and its
// covariance are right, so what lies in one plane errs from the third power of its size on; lights
// off that plane err from the second; lights that are turned from the others at once where x is
// in front of some and behind others, else with their distance from the middle.
float stand_error(Node node, vec3 x, out float d2)
{
    vec3 r = x - node.middle.xyz;
    d2 = max(dot(r, r), 1e-12);
    float inv = inversesqrt(d2), q = node.middle.w * inv, spread = node.spread;
    float up = abs(dot(r, node.axis.xyz)) * inv;
    bool beside = up < spread + node.slack * inv;
    float error = q * q * (q + node.bend) + spread * (beside ? q + 0.5 : q);
    return node.leaf ? 0.0 : q > 0.67 ? 3e38 : error;
}

// Is x behind all lights below the node?
bool is_behind(Node node, vec3 x)
{
    vec3 r = x - node.middle.xyz;
    float most = node.slack + node.spread * length(r);
    return dot(r, node.axis.xyz) + most < light_closest;
}

// Is the node's worst light, d from its rim, near to any degree: near_error of window.glsl against where
// the window begins. Both sides are multiplied out: a division costs as much as ten products.
bool any_near(Node node, float d, float depth, float mean_irradiance)
{
    float h = near_pixels * view.eye.w * depth, d2 = d * d;
    float begins = exp2(-0.5 * tau_width) * tau * mean_irradiance;
    return node.strongest * h * h > begins * d2 * (PI * d2 + node.smallest);
}

// Is it far enough from x to be taken for one light: no light below is near, and the triangle
// errs by no more than a share merge of the mean irradiance. all_far: no light below is near to any degree, and three
// points on the triangle are enough.
bool is_one_light(Node node, vec3 x, float depth, float mean_irradiance, out bool all_far)
{
    float d2;
    bool good = stand_error(node, x, d2) * node.axis.w <= merge * mean_irradiance * PI * d2;
    all_far = node.middle.w * node.middle.w < THREE_POINTS * THREE_POINTS * d2;
    if (tau > 0.0) {
        float d = max(sqrt(d2) - node.reach, 1e-6);
        bool near = any_near(node, d, depth, mean_irradiance);
        good = good && !near;
        all_far = all_far && !near;
    }
    return good || node.leaf;
}

#endif
