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

// What a depth may change by where it is projected again: some 16 steps of a float below 1. The
// paper blames its test without any for visible errors.
const float rounding = 1e-6;

// The position is taken from the G-buffer at the corner: at the pixel of the box's own last texel
// there. Where its projection lies outside the box, the mean of the points where the view ray meets
// the box's planes takes its place: on the screen that ray is the line along depth through the
// corner, and the planes are those of nearest and farthest depth.
Corner corner_of(int vertex)
{
    Corner c;
    c.box = boxes[quads[vertex / 4]];
    bvec2 high = bvec2((vertex & 1) != 0, (vertex & 2) != 0);
    uvec2 texel = mix(c.box.low, c.box.high, high);
    vec2 ndc = 2.0 * vec2(texel + uvec2(high)) / float(SIDE) - 1.0; // the texel's outer corner
    c.before = texelFetch(position_image, pixel_of_texel(ivec2(texel), view.size.xy), 0);
    vec4 clip = view.clip_from_world * vec4(c.before.xyz, 1.0);
    vec3 screen = vec3((0.5 * clip.xy / clip.w + 0.5) * float(SIDE), clip.z / clip.w);
    vec2 z = vec2(uintBitsToFloat(c.box.z_low), uintBitsToFloat(c.box.z_high));
    // where a pixel is larger than a texel its centre may be outside of a box it belongs to
    vec3 slack = vec3(float(SIDE) / vec2(view.size.xy), rounding);
    c.corrected = !(c.before.w > 0.0
        && all(greaterThanEqual(screen, vec3(c.box.low, z.x) - slack))
        && all(lessThanEqual(screen, vec3(c.box.high + 1u, z.y) + slack)));
    vec4 middle = view.world_from_clip * vec4(ndc, 0.5 * (z.x + z.y), 1.0);
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
