// vertex.glsl: what a vertex knows of the far light, and what that gives at a point near it.
//
// The irradiance at x on a surface with normal n is  n.M n + B.n + c + G.(x - x_v/2),  each
// coefficient interpolated between vertices: M and B are the radiance's moments up to order 2; c is
// what they miss at the vertex's own normal, G the gradient over position there and x_v the place
// of the vertex. With half of the gradient in c, what is linear and quadratic between the vertices
// comes out exactly, and the vertices need not lie where the quad wanted them. Order 4, which matters
// for normals unlike the vertex's, is kept of the luminance and takes the colour of the rest; orders 6 and 8
// are guessed from it (spot_of in moments.glsl).
#ifndef VERTEX_GLSL
#define VERTEX_GLSL

const int VERTEX_VECTORS = 13;

struct Vertex {
    vec4 red0, green0, blue0; // M: xx, yy, zz, xy
    vec4 red1, green1, blue1; // M: xz, yz; B: x, y
    vec4 b;                   // B: z red, green, blue; w: Fourth.c
    vec4 place;               // x_v/2; c red
    vec4 gradient0;           // red; c green
    vec4 gradient1;           // green; c blue
    vec4 gradient2;           // blue; spot_of the mean of the colours
    vec4 fourth_a, fourth_b;  // Fourth, of the mean of the colours
};

// Along the radiance's first moment, over the colours.
vec3 vertex_axis(Vertex v)
{
    return vec3(v.red1.zw + v.green1.zw + v.blue1.zw, v.b.x + v.b.y + v.b.z);
}

vec3 vertex_irradiance(Vertex v, vec3 x, vec3 n)
{
    vec4 s0 = vec4(n * n, 2.0 * n.x * n.y), s1 = vec4(2.0 * n.xy * n.z, n.xy);
    vec3 d = x - v.place.xyz;
    vec3 moments = vec3(dot(v.red0, s0) + dot(v.red1, s1), dot(v.green0, s0) + dot(v.green1, s1),
                        dot(v.blue0, s0) + dot(v.blue1, s1))
        + v.b.xyz * n.z;
    vec3 color = color_of(vec3(v.red0.x + v.red0.y + v.red0.z, v.green0.x + v.green0.y + v.green0.z,
                               v.blue0.x + v.blue0.y + v.blue0.z));
    moments += color * (fourth_order(Fourth(v.fourth_a, v.fourth_b, v.b.w), n)
                        + higher_orders(v.gradient2.w, vertex_axis(v), n));
    return moments + vec3(v.place.w, v.gradient0.w, v.gradient1.w)
        + vec3(dot(v.gradient0.xyz, d), dot(v.gradient1.xyz, d), dot(v.gradient2.xyz, d));
}

Vertex vertex_zero()
{
    const vec4 o = vec4(0.0);
    return Vertex(o, o, o, o, o, o, o, o, o, o, o, o, o);
}

// Takes in the share far of a light of exitance e.
void vertex_take(inout Vertex v, vec3 e, float far, Moments m, Fourth f)
{
    TAKE_FAR(v, e, far, m, f)
}

// The vertex lies at x; next is vertex_local.
void vertex_finish(inout Vertex v, vec3 x)
{
    v.place.xyz = 0.5 * x;
    v.gradient2.w = spot_of(v.red0.xyz + v.green0.xyz + v.blue0.xyz, vertex_axis(v),
                            Fourth(v.fourth_a, v.fourth_b, v.b.w));
}

// What the vertex misses of the irradiance at its own place and normal.
void vertex_local(inout Vertex v, vec3 c)
{
    v.place.w = c.r;
    v.gradient0.w = c.g;
    v.gradient1.w = c.b;
}

void vertex_add(inout Vertex v, float weight, Vertex w)
{
    v.red0 += weight * w.red0;
    v.green0 += weight * w.green0;
    v.blue0 += weight * w.blue0;
    v.red1 += weight * w.red1;
    v.green1 += weight * w.green1;
    v.blue1 += weight * w.blue1;
    v.b += weight * w.b;
    v.place += weight * w.place;
    v.gradient0 += weight * w.gradient0;
    v.gradient1 += weight * w.gradient1;
    v.gradient2 += weight * w.gradient2;
    v.fourth_a += weight * w.fourth_a;
    v.fourth_b += weight * w.fourth_b;
}

#endif
