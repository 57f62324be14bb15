// descent.glsl: which lights, or nodes that stand for lights, points find in the tree.
#ifndef DESCENT_GLSL
#define DESCENT_GLSL

#include "tree.glsl"

// How many points descend at once: what lavapipe fetches of the tree costs more than what is done with it.
#ifndef TOGETHER
#define TOGETHER 1
#endif

// A point, and the first node that it has not done with: at first 0, or nodes_end where there is no point.
struct Seeker {
    vec3 x;
    float depth;
    uint next;
};

// What a descent has found: which node in the lower FOUND_BITS bits, above them a bit for each of the
// points that it is for. A node may be in both lists, for different points.
const uint FOUND_BITS = 24u, FOUND_NODES = (1u << FOUND_BITS) - 1u, MOST_FOUND = 32u;
uint found_far[MOST_FOUND];  // all that is below is far and three points are enough
uint found_near[MOST_FOUND]; // all others
uint found_far_count, found_near_count; // how many of each

// Goes on at the node `at` (less than nodes_end; at first 0) to that of the next descent, through MOST_FOUND nodes at
// most, always the same ones: what a point finds comes in an order that no other point has a say in.
// tested: grows by the nodes that were tested.
void find_lights(inout uint at, inout Seeker seekers[TOGETHER], float mean_irradiance, inout uint tested)
{
    uint end = min((at / MOST_FOUND + 1u) * MOST_FOUND, nodes_end);
    found_far_count = 0u;
    found_near_count = 0u;
    do {
        Node node = read_node(at);
        uint far = 0u, near = 0u;
        bool open = false;
        [[unroll]] for (int k = 0; k < TOGETHER; k++) {
            bool all_far, seeks = at >= seekers[k].next;
            bool take = is_one_light(node, seekers[k].x, seekers[k].depth, mean_irradiance, all_far);
            bool behind = is_behind(node, seekers[k].x), done = take || behind;
            tested += seeks && (!node.leaf || behind) ? 1u : 0u; // the others are evaluated, and counted then
            uint bit = seeks && take && !behind ? 1u << (FOUND_BITS + uint(k)) : 0u;
            far |= all_far ? bit : 0u;
            near |= all_far ? 0u : bit;
            seekers[k].next = seeks && done ? node.skip : seekers[k].next;
            open = open || (seeks && !done);
        }
        found_far[found_far_count] = at | far;
        found_far_count += far != 0u ? 1u : 0u;
        found_near[found_near_count] = at | near;
        found_near_count += near != 0u ? 1u : 0u;
        at = open ? at + 1u : node.skip;
    } while (at < end);
}

// The share of a node's light that is far from x, and the gradient of the near one: what stands for many is far.
float far_share(Light l, bool leaf, vec3 x, float depth, float mean_irradiance, out vec3 near_gradient)
{
    float near = near_weight(l, x, depth, mean_irradiance, near_gradient);
    near_gradient = leaf ? near_gradient : vec3(0.0);
    return leaf ? 1.0 - near : 1.0;
}

// The i-th node of both lists.
uint found_at(uint i)
{
    return (i < found_far_count ? found_far[i] : found_near[i - found_far_count]) & FOUND_NODES;
}

// Is this one for the k-th point?
bool is_found_for(uint found, int k)
{
    return (found >> (FOUND_BITS + uint(k)) & 1u) != 0u;
}

#endif
