// vertex.glsl: what a vertex knows of the far light, and what that gives at a point near it.
//
// The irradiance at x on a surface with normal n is  n.M n + B.n + c + G.(x - x_v/2),  each
// coefficient interpolated between vertices: M and B are the radiance's moments up to order 2; c is
// what they miss at the vertex's own normal, G the gradient over position there and x_v the place
// of the vertex. With half of the gradient in c, what is linear and quadratic between the vertices
// comes out exactly, and the vertices need not lie where the quad wanted them. c and G fade out for
// pixels whose normals are far from those of the vertices.
#ifndef VERTEX_GLSL
#define VERTEX_GLSL

// cosines between the normals of a pixel and of the vertices: without c and G, and with all of them
const float NORMAL_FAR = 0.2, NORMAL_NEAR = 0.9;

const int VERTEX_VECTORS = 12;

struct Vertex {
    vec4 red0, green0, blue0; // M: xx, yy, zz, xy
    vec4 red1, green1, blue1; // M: xz, yz; B: x, y
    vec4 b;                   // B: z red, green, blue; w: 0
    vec4 place;               // x_v/2; c red
    vec4 gradient0;           // red; c green
    vec4 gradient1;           // green; c blue
    vec4 gradient2;           // blue; w: 0
    vec4 normal;              // for which c and G hold; w: 0
};

vec3 vertex_irradiance(Vertex v, vec3 x, vec3 n)
{
    vec4 s0 = vec4(n * n, 2.0 * n.x * n.y), s1 = vec4(2.0 * n.xy * n.z, n.xy);
    vec3 d = x - v.place.xyz;
    vec3 moments = vec3(dot(v.red0, s0) + dot(v.red1, s1), dot(v.green0, s0) + dot(v.green1, s1),
                        dot(v.blue0, s0) + dot(v.blue1, s1))
        + v.b.xyz * n.z;
    vec3 local = vec3(v.place.w, v.gradient0.w, v.gradient1.w)
        + vec3(dot(v.gradient0.xyz, d), dot(v.gradient1.xyz, d), dot(v.gradient2.xyz, d));
    return moments + smoothstep(NORMAL_FAR, NORMAL_NEAR, dot(n, v.normal.xyz)) * local;
}

Vertex vertex_zero()
{
    const vec4 o = vec4(0.0);
    return Vertex(o, o, o, o, o, o, o, o, o, o, o, o);
}

// Takes in the share far of a light of exitance e.
void vertex_take(inout Vertex v, vec3 e, float far, Moments m)
{
    vec3 s = far / PI * (15.0 / 32.0 * m.squares + 3.0 / 32.0 * m.solid_angle);
    vec3 p = far / PI * 15.0 / 32.0 * m.products, b = far * 0.5 / PI * m.first;
    vec4 m0 = vec4(s, p.x), m1 = vec4(p.yz, b.xy);
    v.red0 += e.r * m0;
    v.green0 += e.g * m0;
    v.blue0 += e.b * m0;
    v.red1 += e.r * m1;
    v.green1 += e.g * m1;
    v.blue1 += e.b * m1;
    v.b.xyz += e * b.z;
}

void vertex_finish(inout Vertex v)
{
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
    v.normal += weight * w.normal;
}

#endif
