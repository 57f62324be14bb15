// spot.glsl: does a light without shadow give more between the samples of a fragment than at them, or
// much more at some of them: it may be closer to the surface than the fragment is wide.
#ifndef SPOT_GLSL
#define SPOT_GLSL

// Of the mean irradiance, from one light: between the samples, and from one of them to another.
const float SPOT = 1.0, STEEP = 4.0;

shared vec4 spot_places[64];

// Looks at the four samples, the corners, and the place below the light or the nearest to it among
// them. In uniform control flow.
bool is_uneven(uint light, Surface s, Surface corner, float form)
{
    uint mine = gl_LocalInvocationIndex, first = mine & ~3u;
    vec3 low = vec3(3e38), high = vec3(-3e38);
    float most = 0.0, least = 3e38;
    for (uint turn = 0u; turn < 2u; turn++) {
        spot_places[mine] = turn == 0u ? vec4(s.position, form)
                                       : vec4(corner.position, area_form_factor(light, corner));
        barrier();
        for (uint i = first; i < first + 4u; i++) {
            low = min(low, spot_places[i].xyz);
            high = max(high, spot_places[i].xyz);
            most = max(most, spot_places[i].w);
            least = min(least, spot_places[i].w);
        }
        barrier();
    }
    Surface below = s;
    vec3 away = areas[light].middle.xyz - s.position;
    below.position = clamp(s.position + away - dot(away, s.normal) * s.normal, low, high);
    below.position -= dot(below.position - s.position, s.normal) * s.normal;
    float found = s.there && corner.there ? area_form_factor(light, below) : 0.0;
    return worth_of(light, max(found - most, 0.0)) > SPOT || worth_of(light, most - least) > STEEP;
}

#endif
