// tilted.glsl: four normals around a vertex's own, for which gather_lobe.comp notes the irradiance and
// fit_lobe.comp moves the lobes.
#ifndef TILTED_GLSL
#define TILTED_GLSL

const float TILT = 0.5; // sine of the angle to the vertex's normal

// The four are the first column with the second added and taken away, and with the third.
mat3 tilt_frame(vec3 n)
{
    vec3 side = normalize(cross(abs(n.y) < 0.8 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), n));
    return mat3(sqrt(1.0 - TILT * TILT) * n, TILT * side, TILT * cross(n, side));
}

#ifdef FORM_FACTOR_GLSL

// Form factors of a light for the four, by the three points of far_light; m: its moments there.
vec4 tilted_far(Light l, vec3 x, vec3 n, Moments m)
{
    mat3 frame = tilt_frame(n);
    vec4 sum = vec4(0.0);
    float all = 0.0;
    vec3 middle = (l.a.xyz + l.b.xyz + l.c.xyz) / 6.0 - x;
    for (int i = 0; i < 3; i++) {
        vec3 r = middle + 0.5 * (i == 0 ? l.a.xyz : i == 1 ? l.b.xyz : l.c.xyz);
        float inv2 = 1.0 / max(dot(r, r), 1e-12);
        vec3 w = r * sqrt(inv2), c = w * frame;
        float solid_angle = max(-dot(l.plane.xyz, w), 0.0) * inv2;
        sum += solid_angle * max(vec4(c.x + c.yz, c.x - c.yz), 0.0);
        all += solid_angle;
    }
    return sum.xzyw * (m.solid_angle / (PI * max(all, 1e-20)));
}

// The same of a light that is too near for points.
vec4 tilted_near(Light l, vec3 x, vec3 n)
{
    mat3 f = tilt_frame(n);
    return vec4(form_factor(l, x, f[0] + f[1]), form_factor(l, x, f[0] - f[1]),
                form_factor(l, x, f[0] + f[2]), form_factor(l, x, f[0] - f[2]));
}

#endif

#endif
