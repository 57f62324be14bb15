// compare.glsl: what four sub-fragments see, bit by bit (3.1.2) and by number (3.1.3).
#ifndef COMPARE_GLSL
#define COMPARE_GLSL

uvec2 sub_at(uint sub) // of the four around the fragment: each a neighbour of the one before
{
    return uvec2(sub == 1u || sub == 2u, sub >= 2u);
}

struct Found {
    uint differ; // bits, most of all lights
    uint twice;  // sub-fragments on a steep gradient
    bool half_shadow;
};

// seen: bits of the four. Returns whether the gradient of this light is steep.
bool compare(bool joined, uint seen[4], inout Found found)
{
    uint all = 0xffffu, any = 0u, before = found.twice;
    found.twice = 0u;
    for (uint i = 0u; i < 4u; i++) {
        uint next = seen[(i + 1u) & 3u];
        all &= seen[i];
        any |= seen[i];
        int gradient = bitCount(seen[i]) - bitCount(next);
        if (uint(abs(gradient)) > steep)
            found.twice |= 1u << i | 1u << ((i + 1u) & 3u);
    }
    bool part = any != 0u && all != 0xffffu;
    uint differ = joined && part ? 16u : joined ? 0u : bitCount(any & ~all);
    found.differ = max(found.differ, differ);
    found.half_shadow = found.half_shadow || part;
    bool is_steep = found.twice != 0u;
    found.twice |= before;
    return is_steep;
}

#endif
