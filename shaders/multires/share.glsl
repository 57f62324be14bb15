// share.glsl: what one of four sub-fragments knows of a light, and the four together; test.glsl has
// the struct Sub.
#ifndef SHARE_GLSL
#define SHARE_GLSL

shared vec3 share_weights[64]; // z: worth

// Of the four of this invocation's fragment where it is worth most; in uniform control flow.
float share_worth(float worth)
{
    uint mine = gl_LocalInvocationIndex, first = mine & ~3u;
    share_weights[mine].z = worth;
    barrier();
    float most = 0.0;
    for (uint i = 0u; i < 4u; i++)
        most = max(most, share_weights[first + i].z);
    return most;
}

// What the four see, after queue_trace; weights of what this one sees, and of all; in uniform
// control flow.
Seen share_seen(vec2 weights, float worth)
{
    uint mine = gl_LocalInvocationIndex, first = mine & ~3u;
    barrier();
    share_weights[mine].xy = weights;
    barrier();
    Seen seen;
    seen.together = vec2(0.0);
    seen.any = uvec2(0u);
    seen.all = uvec2(0xffffffffu);
    seen.worth = worth;
    for (uint i = 0u; i < 4u; i++) {
        uvec2 board = queue_answer(first + i);
        seen.counts[i] = count_squares(board);
        seen.any |= board;
        seen.all &= board;
        seen.together += share_weights[first + i].xy;
    }
    return seen;
}

void keep_light(uint light, bool part, float form, vec2 weights, Surface s, inout Sub sub)
{
    float whole = s.there ? form_after_test(light, s, form, weights.x, weights.y) : 0.0;
    vec3 open = areas[light].exitance.rgb * whole;
    sub.light += weights.x > 0.0 ? open * (weights.x / weights.y) : vec3(0.0);
    sub.half_light += part ? open.r + open.g + open.b : 0.0;
}

#endif
