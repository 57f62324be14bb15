// visibility.glsl: how one place sees a light: an invocation traces all its rays, so that neighbours
// follow much the same way through the tree.
#ifndef VISIBILITY_GLSL
#define VISIBILITY_GLSL

const float BRIGHT = 0.3; // worth above which a light is looked at by all points

// Adds a set of 16 of the 64 points. Returns the bits of those that are visible.
uint see_set(uint light, Surface s, uint set, inout vec2 weights, inout uint rays)
{
    uint bits = 0u, i = 0u;
    for (; i < 16u; i++) {
        float weight = area_weight(light, set * 16u + i, s);
        weights.y += weight;
        if (weight > 0.0) {
            rays++;
            if (area_sees(light, set * 16u + i, s)) {
                weights.x += weight;
                bits |= 1u << i;
            }
        }
    }
    trace_gave_up = trace_gave_up || i < 16u;
    return bits;
}

// What a light gives without shadow, the mean of the channels over the image's mean irradiance.
float worth_of(uint light, float form)
{
    vec3 open = areas[light].exitance.rgb * form;
    float mean = uintBitsToFloat(work[MEAN].groups[0]), value = (open.r + open.g + open.b) / 3.0;
    return mean > 0.0 ? value / mean : value > 0.0 ? 1e9 : 0.0;
}

bool in_part(uint bits)
{
    return bits != 0u && bits != 0xffffu;
}

#endif
