// queue.glsl: the rays that the places of a work group want traced to one light, side by side: an
// invocation traces one after the other of them, whichever place they are from, so that none waits
// for another whose place wants more. Places: 64, one an invocation.
#ifndef QUEUE_GLSL
#define QUEUE_GLSL

#include "changes.glsl"

const uint QUEUE = 2048u; // rays at a time

// A bit a square of the board of a light's points, see changes.glsl; .x of all, then .y of all.
shared uint queue_wanted[128];
shared uint queue_seen[128];
shared vec3 queue_origins[64];
shared uint queue_starts[65]; // of what each invocation writes
shared uint queue_rays[QUEUE];

void queue_ask(Surface s, uvec2 wanted)
{
    uint mine = gl_LocalInvocationIndex;
    queue_origins[mine] = s.origin;
    queue_wanted[mine] = wanted.x;
    queue_wanted[64u + mine] = wanted.y;
    queue_seen[mine] = 0u;
    queue_seen[64u + mine] = 0u;
}

// After queue_trace.
uvec2 queue_answer(uint place)
{
    return uvec2(queue_seen[place], queue_seen[64u + place]);
}

// An invocation writes what the four places of a fragment want of 4 x 4 squares of the board, 16
// bits each, by 2 x 2 squares: the rays that go down the tree together are from few places.
uvec2 queue_line()
{
    uint mine = gl_LocalInvocationIndex, first = 32u * (mine & 2u) + (mine & 60u);
    uint bits[4];
    for (uint i = 0u; i < 4u; i++) {
        uint rows = queue_wanted[first + i] >> 4u * (mine & 1u) & 0x0f0f0f0fu;
        rows = (rows | rows >> 4) & 0x00ff00ffu;
        rows = (rows | rows >> 8) & 0xffffu;
        bits[i] = (rows & 0xc3c3u) | (rows & 0x0c0cu) << 2 | (rows & 0x3030u) >> 2;
    }
    return uvec2(bits[0] | bits[1] << 16, bits[2] | bits[3] << 16);
}

// The place, then the square from bit 6 on, of a bit of this invocation's line.
uint queue_entry(uint bit)
{
    uint mine = gl_LocalInvocationIndex, place = (mine & 60u) + (bit >> 4);
    uint square = (bit & 1u) | (bit & 4u) >> 1 | (bit & 2u) << 2 | (bit & 8u) << 1;
    return place | (square + 4u * (mine & 1u) + 16u * (mine & 2u)) << 6;
}

void queue_count(uvec2 line)
{
    uint mine = gl_LocalInvocationIndex;
    queue_starts[mine] = uint(bitCount(line.x) + bitCount(line.y));
    barrier();
    uint sum = 0u;
    for (uint i = 0u; i < 64u && mine == 0u; i++) {
        uint count = queue_starts[i];
        queue_starts[i] = sum;
        sum += count;
    }
    if (mine == 0u)
        queue_starts[64] = sum;
    barrier();
}

// After queue_ask, in uniform control flow. Rays from one place to neighbouring points follow much
// the same way through the tree: they are side by side.
void queue_trace(uint light)
{
    uint mine = gl_LocalInvocationIndex;
    barrier();
    uvec2 line = queue_line();
    queue_count(line);
    uint all = queue_starts[64];
    for (uint before = 0u; before < all; before += QUEUE) {
        uint slot = queue_starts[mine] - before;
        uvec2 left = line;
        while (any(notEqual(left, uvec2(0u)))) {
            uint bit = first_square(left);
            left = without_first(left);
            if (slot < QUEUE)
                queue_rays[slot] = queue_entry(bit);
            slot++;
        }
        barrier();
        uint last = min(all - before, QUEUE), i = mine;
        for (; trace_any(i < last); i += 64u) {
            uint entry = i < last ? queue_rays[i] : 0u, place = entry & 63u, square = entry >> 6;
            if (area_sees_from(light, point_on(square), queue_origins[place], i < last))
                atomicOr(queue_seen[place + 2u * (square & 32u)], 1u << (square & 31u));
        }
        trace_gave_up = trace_gave_up || i < last;
        barrier();
    }
}

#endif
