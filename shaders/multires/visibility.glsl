// visibility.glsl: a work group lights several places, 16 rays each to 16 points of every light.
// Before including it: #define PLACES; a work group has 16 times as many invocations,
// the places next to each other: their rays to one point follow much the same way through the tree.
#ifndef VISIBILITY_GLSL
#define VISIBILITY_GLSL

// How a place sees a light: the bits of its 16 points, and the weights that are seen, and all.
shared uint place_bits[PLACES];
shared float place_seen[PLACES * 16u], place_all[PLACES * 16u];

// Traces one ray, in uniform control flow; fills the above. set: which 16 of the 64 points.
void see_light(uint light, Surface s, uint set, inout uint rays)
{
    uint mine = gl_LocalInvocationIndex, place = mine % PLACES, point = mine / PLACES;
    if (point == 0u)
        place_bits[place] = 0u;
    float weight = s.there ? area_weight(light, set * 16u + point, s) : 0.0;
    bool sees = false;
    if (weight > 0.0) {
        sees = area_sees(light, set * 16u + point, s);
        rays++;
    }
    place_seen[mine] = sees ? weight : 0.0;
    place_all[mine] = weight;
    barrier();
    if (sees)
        atomicOr(place_bits[place], 1u << point);
    barrier();
}

// Sums of the weights of a place, and of all places, added in one order always; for one invocation
// a place.
vec2 sum_place(uint place)
{
    vec2 sum = vec2(0.0);
    for (uint i = place; i < PLACES * 16u; i += PLACES)
        sum += vec2(place_seen[i], place_all[i]);
    return sum;
}

vec2 sum_places()
{
    vec2 sum = vec2(0.0);
    for (uint i = 0u; i < PLACES; i++)
        sum += sum_place(i);
    return sum;
}

#endif
