// moments.glsl: what a triangle of light sends to a point, for every normal at once.
#ifndef MOMENTS_GLSL
#define MOMENTS_GLSL

// Moments of the solid angle that a triangle fills.
struct Moments {
    float solid_angle; // integral of 1
    vec3 first;        // of w
    vec3 squares;      // of w_x^2, w_y^2, w_z^2
    vec3 products;     // of w_x w_y, w_x w_z, w_y w_z
};

// One number for each of the nine harmonics of order 4.
struct Fourth {
    vec4 a, b;
    float c;
};

Fourth harmonics(vec3 w)
{
    vec3 s = w * w;
    float z7 = 7.0 * s.z, xy = w.x * w.y;
    return Fourth(vec4(xy * (s.x - s.y), w.y * w.z * (3.0 * s.x - s.y), xy * (z7 - 1.0),
                       w.y * w.z * (z7 - 3.0)),
                  vec4((35.0 * s.z - 30.0) * s.z + 3.0, w.x * w.z * (z7 - 3.0),
                       (s.x - s.y) * (z7 - 1.0), w.x * w.z * (s.x - 3.0 * s.y)),
                  s.x * (s.x - 3.0 * s.y) - s.y * (3.0 * s.x - s.y));
}

// The irradiance of order 4 on a surface with normal n.
float fourth_order(Fourth sum, vec3 n)
{
    Fourth h = harmonics(n);
    return dot(sum.a, h.a) + dot(sum.b, h.b) + sum.c * h.c;
}

// How much of order 6 light has, if it comes from one spot: what is left there of order 4, squared, is what a blur
// leaves of it. diagonal: of M, the sum over the colours; axis: along the first moment; sum: of the colours' mean.
float spot_of(vec3 diagonal, vec3 axis, Fourth sum)
{
    // M's trace is 3/4 of the integral over solid angle over pi; of order 4 a point has -3/32 of that
    float full = 4.0 / 9.0 * (diagonal.x + diagonal.y + diagonal.z);
    float kept = -32.0 / 3.0 * fourth_order(sum, axis * inversesqrt(max(dot(axis, axis), 1e-30)));
    kept = clamp(kept / max(full, 1e-30), 0.0, 1.0);
    return full * kept * kept;
}

// The irradiance of orders 6 and 8 of such a spot on a surface with normal n: 13/256 P6(x) - 17/512 P8(x), less of that.
float higher_orders(float spot, vec3 axis, vec3 n)
{
    float along = dot(axis, n), s = along * along / max(dot(axis, axis), 1e-30);
    float p6 = (((231.0 * s - 315.0) * s + 105.0) * s - 5.0) * (13.0 / 256.0 / 16.0);
    float p8 = ((((6435.0 * s - 12012.0) * s + 6930.0) * s - 1260.0) * s + 35.0) * (17.0 / 512.0 / 128.0);
    return spot * (p6 - 0.7 * p8);
}

// The colour of mean 1 of the light of which all that there is is given. Of a light seen edge-on
// rounding may leave less than nothing.
vec3 color_of(vec3 light)
{
    light = max(light, 0.0);
    return light * (3.0 / max(light.r + light.g + light.b, 1e-20));
}

// A share of a light's moments as the irradiance n.M n + B.n on a surface with normal n needs them.
struct Terms {
    vec4 m0; // M: xx, yy, zz, xy
    vec4 m1; // M: xz, yz; B: x, y
    float b; // B: z
};

Terms terms_of(Moments m, float share)
{
    vec3 s = share / PI * (15.0 / 32.0 * m.squares + 3.0 / 32.0 * m.solid_angle);
    vec3 p = share / PI * 15.0 / 32.0 * m.products, b = share * 0.5 / PI * m.first;
    return Terms(vec4(s, p.x), vec4(p.yz, b.xy), b.z);
}

// Takes the share far of a light of exitance e, with its moments m and order 4 f, into a vertex or
// a sample v: they have the fields in common that vertex.glsl tells of.
#define TAKE_FAR(v, e, far, m, f)                                                                  \
    {                                                                                              \
        Terms t = terms_of(m, far);                                                                \
        v.red0 += e.r * t.m0;                                                                      \
        v.green0 += e.g * t.m0;                                                                    \
        v.blue0 += e.b * t.m0;                                                                     \
        v.red1 += e.r * t.m1;                                                                      \
        v.green1 += e.g * t.m1;                                                                    \
        v.blue1 += e.b * t.m1;                                                                     \
        float mean_e = (e.r + e.g + e.b) / 3.0 * far;                                              \
        v.b += vec4(e * t.b, mean_e * f.c);                                                        \
        v.fourth_a += mean_e * f.a;                                                                \
        v.fourth_b += mean_e * f.b;                                                                \
    }

#ifdef FORM_FACTOR_GLSL

// One edge's share of the first and second moment; g: cross product of its ends on the unit sphere.
void edge_moments(vec3 v0, vec3 v1, inout Moments m)
{
    vec3 g = cross(v0, v1), s = v0 + v1;
    float d = dot(v0, v1);
    float near = angle_over_sine(min(abs(d), 1.0));
    m.first += 0.5 * g * (d < 0.0 ? PI * inversesqrt(max(dot(g, g), 1e-30)) - near : near);
    s *= 1.0 / max(1.0 + d, 1e-6);
    m.squares += g * s;
    m.products += 0.5 * (g.xxy * s.yzz + s.xxy * g.yzz);
}

// Not clipped to any horizon. The second moment is a boundary integral too: for every edge the
// outer product of its plane's normal and the integral of w along the arc.
Moments light_moments(Light l, vec3 x)
{
    vec3 v0 = normalize(l.c.xyz - x), v1 = normalize(l.b.xyz - x), v2 = normalize(l.a.xyz - x);
    Moments m = Moments(0.0, vec3(0.0), vec3(0.0), vec3(0.0));
    edge_moments(v0, v1, m);
    edge_moments(v1, v2, m);
    edge_moments(v2, v0, m);
    m.solid_angle = 2.0 * atan(max(dot(v0, cross(v1, v2)), 0.0),
                               1.0 + dot(v0, v1) + dot(v1, v2) + dot(v2, v0));
    m.squares = (m.squares + m.solid_angle) / 3.0;
    m.products /= 3.0;
    return m;
}

// What a light far from x sends there, by three points on its triangle with its area, centre and
// covariance: errs from the third power of its size over its distance on.
struct FarLight {
    Moments moments;
    Fourth fourth;     // integrals of the harmonics of order 4, weighted for fourth_order above
    float form_factor; // for normal n
    vec3 gradient;     // of the form factor over x
};

FarLight far_light(Light l, vec3 x, vec3 n)
{
    FarLight s = FarLight(Moments(0.0, vec3(0.0), vec3(0.0), vec3(0.0)), Fourth(vec4(0.0), vec4(0.0), 0.0),
                          0.0, vec3(0.0));
    float along_n = 0.0, along_plane = 0.0; // of the gradient
    vec3 middle = (l.a.xyz + l.b.xyz + l.c.xyz) / 6.0 - x;
    for (int i = 0; i < 3; i++) {
        vec3 r = middle + 0.5 * (i == 0 ? l.a.xyz : i == 1 ? l.b.xyz : l.c.xyz);
        float inv2 = 1.0 / max(dot(r, r), 1e-12), inv = sqrt(inv2);
        vec3 w = r * inv;
        float up = max(dot(n, w), 0.0), out_of = max(-dot(l.plane.xyz, w), 0.0);
        float solid_angle = out_of * inv2;
        vec3 first = solid_angle * w;
        s.moments.solid_angle += solid_angle;
        s.moments.first += first;
        s.moments.squares += first * w;
        s.moments.products += first.xxy * w.yzz;
        Fourth h = harmonics(w);
        s.fourth.a += solid_angle * h.a;
        s.fourth.b += solid_angle * h.b;
        s.fourth.c += solid_angle * h.c;
        s.form_factor += solid_angle * up;
        float steep = up > 0.0 ? inv * inv2 : 0.0;
        s.gradient += (4.0 * up * out_of * steep) * w;
        along_n += out_of * steep;
        along_plane += up * steep;
    }
    s.gradient += along_plane * l.plane.xyz - along_n * n;
    float share = l.plane.w / 3.0;
    s.moments.solid_angle *= share;
    s.moments.first *= share;
    s.moments.squares *= share;
    s.moments.products *= share;
    s.form_factor *= share / PI;
    s.gradient *= share / PI;
    // (4 pi / 9) N^2 of each harmonic, times what the cosine leaves of order 4, -3/32 over pi
    float k = -3.0 / 32.0 / PI * share;
    s.fourth.a *= k * vec4(8.75, 4.375, 1.25, 0.625);
    s.fourth.b *= k * vec4(0.015625, 0.625, 0.3125, 4.375);
    s.fourth.c *= k * 0.546875;
    return s;
}

#endif

#endif
