// visibility.glsl: a work group lights several places, 16 rays each to 16 points of every light.
// Before including it: #define PLACES; a work group has 16 times as many invocations.
#ifndef VISIBILITY_GLSL
#define VISIBILITY_GLSL

// How a place sees a light: the bits of its 16 points, and the weights that are seen, and all.
shared uint place_bits[PLACES];
shared float place_seen[PLACES * 16u], place_all[PLACES * 16u];

// Traces one ray, in uniform control flow; fills the above. set: which 16 of the 64 points. Returns
// the light's form factor.
float see_light(uint light, Surface s, uint set, inout uint rays)
{
    uint mine = gl_LocalInvocationIndex, point = mine & 15u;
    if (point == 0u)
        place_bits[mine / 16u] = 0u;
    float form = s.there ? area_form_factor(light, s) : 0.0;
    float weight = form > 0.0 ? area_weight(light, set * 16u + point, s) : 0.0;
    bool sees = false;
    if (weight > 0.0) {
        sees = area_sees(light, set * 16u + point, s);
        rays++;
    }
    place_seen[mine] = sees ? weight : 0.0;
    place_all[mine] = weight;
    barrier();
    if (sees)
        atomicOr(place_bits[mine / 16u], 1u << point);
    barrier();
    return form;
}

// Sums of the weights of some places that follow each other, added in one order always.
vec2 sum_places(uint first, uint count)
{
    vec2 sum = vec2(0.0);
    for (uint i = first * 16u; i < (first + count) * 16u; i++)
        sum += vec2(place_seen[i], place_all[i]);
    return sum;
}

#endif
