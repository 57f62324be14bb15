// window.glsl: which lights are near.
//
// A light's irradiance is interpolated between vertices with an error of about its contribution
// times (h/d)^2: h the size of a quad there, d its distance. Where that exceeds tau times the mean
// irradiance of the image, a pixel evaluates the light itself (near.comp); elsewhere the vertices
// do (gather.comp). Between lies a smooth window over tau_width powers of 2. The weight depends on
// the place in the world alone, so that pixels and vertices agree on it.
#ifndef WINDOW_GLSL
#define WINDOW_GLSL

// Squared distance of a point from a triangle, and its gradient, as if it were a disc: from the side
// it is that to the rim, so that what lies right beside a light counts as close to it.
float light_distance2(Light l, vec3 x, out vec3 half_gradient)
{
    vec3 middle = (l.a.xyz + l.b.xyz + l.c.xyz) * (1.0 / 3.0);
    vec3 r = x - middle;
    float up = dot(r, l.plane.xyz), radius = sqrt(l.plane.w * (1.0 / PI));
    vec3 aside = r - up * l.plane.xyz;
    float away = length(aside), past = max(away - radius, 0.0);
    half_gradient = up * l.plane.xyz + aside * (past / max(away, 1e-9));
    return max(up * up + past * past, 1e-12);
}

// The estimated error over tau, for a point at that squared distance.
float near_error(Light l, float d2, float depth, float mean_irradiance)
{
    float h = near_pixels * view.eye.w * depth;
    vec3 e = light_exitance(l);
    float contribution = (e.x + e.y + e.z) / 3.0 * l.plane.w / (PI * d2 + l.plane.w);
    return contribution * h * h / (d2 * tau * mean_irradiance);
}

// Where the window is, 0 (far) to 1 (near).
float window_place(float error)
{
    return clamp(0.5 + log2(max(error, 1e-30)) / tau_width, 0.0, 1.0);
}

float window_weight(float t)
{
    return t * t * (3.0 - 2.0 * t);
}

// The weight with which a light is near, and its gradient over the place.
float near_weight(Light l, vec3 x, float depth, float mean_irradiance, out vec3 gradient)
{
    vec3 slope;
    float d2 = light_distance2(l, x, slope);
    float t = window_place(near_error(l, d2, depth, mean_irradiance));
    slope = 2.0 / depth * view.forward.xyz
        - (2.0 / d2 + 2.0 * PI / (PI * d2 + l.plane.w)) * slope;
    gradient = 6.0 * t * (1.0 - t) / (tau_width * log(2.0)) * slope;
    return window_weight(t);
}

#endif
