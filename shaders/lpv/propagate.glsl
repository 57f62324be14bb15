// propagate.glsl: one step: each voxel gathers what its six neighbours send it through its faces,
// less what the geometry between keeps, and sends that on in the next step. Light that passes a
// voxel goes 1/(|x| + |y| + |z|) of its side far in it in the mean, (x, y, z) its direction: that
// is its part in the light that fills the voxel, so that of its flux |x|/(|x| + |y| + |z|) counts
// as irradiance along x.
#include "volume.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer In { Lobes lobes_in[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Out { Lobes lobes_out[]; };
layout(set = 0, binding = 2, std430) readonly buffer Open { vec4 open[]; };
layout(set = 0, binding = 3, std430) buffer Sums { Passed sums[]; };

// What comes in of one colour.
struct Light {
    vec3 along; // flux times direction
    float flux;
    vec3 down, up; // irradiance, times the area of a face, by light towards -x, -y, -z and +x, +y, +z
};

#ifdef LPV_PRINTED
// One lobe through the neighbour's five faces, into which it then shines as if it came from its
// centre: all of a side's light goes on that way.
void receive(inout Light light, vec4 lobe, float share, vec3 ahead, vec3 aside, vec3 up)
{
    float scale = share * lobe.w, a = dot(lobe.xyz, ahead);
    vec4 lateral = vec4(dot(lobe.xyz, aside), 0.0, dot(lobe.xyz, up), 0.0);
    lateral.yw = -lateral.xz;
    float far = scale * FAR_ANGLE * lobe_shape(a);
    vec4 sides = scale * SIDE_ANGLE * lobe_shapes(TO_SIDE.x * a + TO_SIDE.y * lateral);
    float all = dot(sides, vec4(1.0));
    light.flux += far + all;
    light.along += 2.0 / 3.0
        * (far * ahead + (sides.x - sides.y) * aside + (sides.z - sides.w) * up);
    vec3 to = (far + 2.0 / 3.0 * all) * ahead;
    light.up += max(to, vec3(0.0)) + 1.0 / 3.0 * (sides.x * aside + sides.z * up);
    light.down += max(-to, vec3(0.0)) + 1.0 / 3.0 * (sides.y * aside + sides.w * up);
}
#else
// What of one lobe comes in by this face, and keeps its direction: most of the light to the far
// face and a little of that to the far faces of the four neighbours beside the voxel, and of the
// light to the sides the larger part of what is steep and the smaller one of what is flat.
void receive(inout Light light, vec4 lobe, float share, vec3 ahead, vec3 aside, vec3 up)
{
    float scale = share * lobe.w, a = dot(lobe.xyz, ahead);
    vec4 lateral = vec4(dot(lobe.xyz, aside), 0.0, dot(lobe.xyz, up), 0.0);
    lateral.yw = -lateral.xz;
    float far = scale * FAR_ANGLE * STRAIGHT * lobe_shape(a);
    vec4 astray = scale * FAR_ANGLE * (0.25 - 0.25 * STRAIGHT) * lobe_shapes(lateral);
    vec4 steep = scale * SIDE_ANGLE * MAJOR * lobe_shapes(TO_SIDE.x * a + TO_SIDE.y * lateral);
    vec4 level = scale * SIDE_ANGLE * (1.0 - MAJOR)
        * lobe_shapes(TO_SIDE.y * a + TO_SIDE.x * lateral);
    float all_steep = dot(steep, vec4(1.0)), all_flat = dot(level, vec4(1.0));
    light.flux += far + dot(astray, vec4(1.0)) + all_steep + all_flat;
    vec4 net = FAR_MEAN * astray + SIDE_MEAN.y * steep + SIDE_MEAN.x * level;
    light.along += (FAR_MEAN * far + SIDE_MEAN.x * all_steep + SIDE_MEAN.y * all_flat) * ahead
        + (net.x - net.y) * aside + (net.z - net.w) * up;
    vec3 to = (STRAIGHT * far + MAJOR * all_steep + (1.0 - MAJOR) * all_flat) * ahead;
    vec4 on = (0.25 - 0.25 * STRAIGHT) * far + astray + (1.0 - MAJOR) * steep + MAJOR * level;
    light.up += max(to, vec3(0.0)) + on.x * aside + on.z * up;
    light.down += max(-to, vec3(0.0)) + on.y * aside + on.w * up;
}
#endif

void from(inout Light light[3], uvec3 place, ivec3 step, float share, vec3 aside, vec3 up)
{
    Lobes lobes = lobes_in[voxel_at(uvec3(ivec3(place) + step))];
    receive(light[0], lobes.red, share, -vec3(step), aside, up);
    receive(light[1], lobes.green, share, -vec3(step), aside, up);
    receive(light[2], lobes.blue, share, -vec3(step), aside, up);
}

void main()
{
    uint voxel = gl_GlobalInvocationID.x;
    if (voxel >= voxels)
        return;
    uvec3 place = place_of(voxel);
    vec3 here = open[voxel].xyz;
    Light light[3];
    for (int c = 0; c < 3; c++)
        light[c] = Light(vec3(0.0), 0.0, vec3(0.0), vec3(0.0));
    if (place.x > 0u)
        from(light, place, ivec3(-1, 0, 0), open[voxel - 1u].x, Y, Z);
    if (place.x + 1u < size.x)
        from(light, place, ivec3(1, 0, 0), here.x, Y, Z);
    if (place.y > 0u)
        from(light, place, ivec3(0, -1, 0), open[voxel - size.x].y, Z, X);
    if (place.y + 1u < size.y)
        from(light, place, ivec3(0, 1, 0), here.y, Z, X);
    if (place.z > 0u)
        from(light, place, ivec3(0, 0, -1), open[voxel - size.x * size.y].z, X, Y);
    if (place.z + 1u < size.z)
        from(light, place, ivec3(0, 0, 1), here.z, X, Y);
    for (int k = 0; k < 3; k++) {
        sums[voxel].by[2 * k].rgb += vec3(light[0].up[k], light[1].up[k], light[2].up[k]);
        sums[voxel].by[2 * k + 1].rgb += vec3(light[0].down[k], light[1].down[k], light[2].down[k]);
    }
    lobes_out[voxel] = Lobes(lobe_of(harmonics_of(light[0].along, light[0].flux)),
                             lobe_of(harmonics_of(light[1].along, light[1].flux)),
                             lobe_of(harmonics_of(light[2].along, light[2].flux)));
}
