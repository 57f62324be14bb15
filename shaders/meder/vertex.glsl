// vertex.glsl: a corner of a segment's quad: where it is, what arrives there.
#define COUNTERS_BINDING 2
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "gather.glsl"
#include "meder.glsl"

layout(set = 0, binding = 3, std430) readonly buffer Boxes { Box boxes[]; };
layout(set = 0, binding = 4, std430) readonly buffer Quads { uint quads[]; };
layout(set = 0, binding = 5) uniform sampler2D position_image;

layout(location = 0) out vec3 red_axis;
layout(location = 1) out vec3 green_axis;
layout(location = 2) out vec3 blue_axis;
layout(location = 3) out vec3 sharpness;
layout(location = 4) out vec3 amplitude;
layout(location = 5) flat out uvec3 segment; // depth bounds as bits, then tile and label

struct Corner {
    vec4 before;   // position in the G-buffer; w: 0 where it has none there
    vec3 position; // after the correction
    bool corrected;
    vec4 clip;
    Box box;
};

// The position is taken from the G-buffer at the corner. Where it lies outside the box, the mean of
// the points where the view ray meets the box's planes takes its place: on the screen that ray
// is the line along depth through the corner, and the planes are those of nearest and farthest
// depth.
Corner corner_of(int vertex)
{
    Corner c;
    c.box = boxes[quads[vertex / 4]];
    uvec2 at = uvec2((vertex & 1) != 0 ? c.box.high.x + 1u : c.box.low.x,
                     (vertex & 2) != 0 ? c.box.high.y + 1u : c.box.low.y);
    vec2 ndc = 2.0 * vec2(at) / float(SIDE) - 1.0;
    // the pixel at the corner, of the four around it the one inside the box
    uvec2 size = view.size.xy;
    uvec2 pixel = uvec2((vertex & 1) != 0 ? (at.x * size.x + SIDE - 1u) / SIDE - 1u
                                          : at.x * size.x / SIDE,
                        (vertex & 2) != 0 ? (at.y * size.y + SIDE - 1u) / SIDE - 1u
                                          : at.y * size.y / SIDE);
    c.before = texelFetch(position_image, ivec2(pixel), 0);
    vec4 clip = view.clip_from_world * vec4(c.before.xyz, 1.0);
    vec3 screen = vec3((0.5 * clip.xy / clip.w + 0.5) * float(SIDE), clip.z / clip.w);
    float z_low = uintBitsToFloat(c.box.z_low), z_high = uintBitsToFloat(c.box.z_high);
    // a pixel's centre is not its corner: across, a pixel of tolerance
    vec2 slack = float(SIDE) / vec2(size);
    c.corrected = !(c.before.w > 0.0
        && all(greaterThanEqual(screen, vec3(vec2(c.box.low) - slack, z_low)))
        && all(lessThanEqual(screen, vec3(vec2(c.box.high + 1u) + slack, z_high))));
    vec4 middle = view.world_from_clip * vec4(ndc, 0.5 * (z_low + z_high), 1.0);
    c.position = c.corrected ? middle.xyz / middle.w : c.before.xyz;
    // drawn at the corner itself, with the depth and the perspective of the position
    c.clip = view.clip_from_world * vec4(c.position, 1.0);
    c.clip.xy = ndc * c.clip.w;
    return c;
}

Lobes light_corner(Corner c)
{
    Lobes lobes = gather(c.position, view.size.z);
    counter_add(COUNT_EVALUATIONS, view.size.z);
    counter_add(COUNT_VERTICES, 1u);
    gl_Position = c.clip;
    red_axis = lobes.axis[0];
    green_axis = lobes.axis[1];
    blue_axis = lobes.axis[2];
    sharpness = lobes.sharpness;
    amplitude = lobes.amplitude;
    segment = uvec3(c.box.z_low, c.box.z_high, c.box.segment);
    return lobes;
}
