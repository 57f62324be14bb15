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

// The mean irradiance, the mean of the channels, of those of the four that are there; in uniform
// control flow.
float share_light(vec3 light, bool there)
{
    uint mine = gl_LocalInvocationIndex, first = mine & ~3u;
    barrier();
    share_weights[mine].xy = vec2(there ? (light.r + light.g + light.b) / 3.0 : 0.0, there);
    barrier();
    vec2 sum = vec2(0.0);
    for (uint i = 0u; i < 4u; i++)
        sum += share_weights[first + i].xy;
    return sum.x / max(sum.y, 1.0);
}

// What larger fragments around one of this level estimated, over the image's mean irradiance; 1
// where none did.
float local_estimate(uvec2 at)
{
    for (uint l = level + 1u; l <= TOP; l++) {
        vec4 value = illumination[fragment_index(l, at >> (l - level))];
        if (value.w == NOTHING && value.y > 0.0)
            return over_mean(value.x);
    }
    return 1.0;
}

void keep_light(uint light, bool part, float form, vec2 weights, Surface s, inout Sub sub)
{
    float whole = s.there ? form_after_test(light, s, form, weights.x, weights.y) : 0.0;
    vec3 open = areas[light].exitance.rgb * whole;
    sub.light += weights.x > 0.0 ? open * (weights.x / weights.y) : vec3(0.0);
    sub.half_light += part ? open.r + open.g + open.b : 0.0;
}

#endif
