/* render_reference.h: what the small scene of render_fixture.h should look like, in double
 * precision: rays against its triangles, form factors of its lights. */
#ifndef RENDER_REFERENCE_H
#define RENDER_REFERENCE_H

#include "render_fixture.h"

static inline void ray_of_pixel(const render_camera *camera, int x, int y, int width, int height,
                                double along[3])
{
    double forward[3], right[3], up[3], slope = tan(camera->fov_y_deg * pi / 360);
    for (int i = 0; i < 3; i++)
        forward[i] = camera->target[i] - camera->eye[i];
    fixture_unit(forward);
    fixture_cross(forward, camera->up, right);
    fixture_unit(right);
    fixture_cross(right, forward, up);
    double across = slope * width / height * (2 * (x + 0.5) / width - 1);
    double down = slope * (2 * (y + 0.5) / height - 1);
    for (int i = 0; i < 3; i++) /* of length 1 along the view axis */
        along[i] = forward[i] + across * right[i] - down * up[i];
}

/* Nearest triangle along a ray and its distance, -1 and infinity: none. edge: how close the ray
 * comes to an edge of anything that it meets or nearly meets, as a barycentric coordinate. */
static inline int fixture_trace(const fixture *f, const double from[3], const double along[3],
                                double *distance, double *edge)
{
    int nearest = -1;
    *distance = INFINITY;
    *edge = 1;
    for (size_t t = 0; t < f->scene.triangle_count; t++) {
        double p[3][3], u[3], v[3], h[3], s[3], q[3];
        for (int corner = 0; corner < 3; corner++)
            fixture_corner(f, t, corner, p[corner]);
        for (int i = 0; i < 3; i++) {
            u[i] = p[1][i] - p[0][i];
            v[i] = p[2][i] - p[0][i];
            s[i] = from[i] - p[0][i];
        }
        fixture_cross(along, v, h);
        double determinant = fixture_dot(u, h);
        if (fabs(determinant) < 1e-12)
            continue;
        fixture_cross(s, u, q);
        double a = fixture_dot(s, h) / determinant, b = fixture_dot(along, q) / determinant;
        double at = fixture_dot(v, q) / determinant;
        double inside = fmin(fmin(a, b), 1 - a - b);
        if (at > 0)
            *edge = fmin(*edge, fabs(inside));
        if (inside >= 0 && at > 0 && at < *distance) {
            *distance = at;
            nearest = (int)t;
        }
    }
    return nearest;
}

/* The part of a hemisphere around n, weighted by its cosine, that a triangle fills seen from x: cut
 * at the horizon corner by corner, then Lambert's sum with acos. Nothing from behind. */
static inline double fixture_form_factor(double corners[3][3], const double x[3], const double n[3])
{
    double p[6][3], face[3], side[2][3];
    int count = 0;
    for (int i = 0; i < 3; i++) {
        side[0][i] = corners[1][i] - corners[0][i];
        side[1][i] = corners[2][i] - corners[0][i];
    }
    fixture_cross(side[0], side[1], face);
    fixture_unit(face);
    double to_x[3] = {x[0] - corners[0][0], x[1] - corners[0][1], x[2] - corners[0][2]};
    if (fixture_dot(face, to_x) < 0.002)
        return 0;
    for (int corner = 0; corner < 3; corner++) {
        double a[3], b[3];
        for (int i = 0; i < 3; i++) {
            a[i] = corners[corner][i] - x[i];
            b[i] = corners[(corner + 1) % 3][i] - x[i];
        }
        double high = fixture_dot(a, n), low = fixture_dot(b, n);
        if (high >= 0)
            memcpy(p[count++], a, sizeof a);
        if ((high < 0) != (low < 0)) {
            for (int i = 0; i < 3; i++)
                p[count][i] = a[i] + (b[i] - a[i]) * high / (high - low);
            count++;
        }
    }
    double sum = 0;
    for (int i = 0; i < count; i++) {
        double g[3], *a = p[i], *b = p[(i + 1) % count];
        fixture_cross(a, b, g);
        double length = sqrt(fixture_dot(g, g));
        if (length > 0)
            sum -= atan2(length, fixture_dot(a, b)) * fixture_dot(g, n) / length;
    }
    return sum > 0 ? sum / (2 * 3.14159265358979323846) : 0;
}

static inline double light_corners(const light_data *light, double corners[3][3])
{
    const float *const places[3] = {light->a, light->b, light->c};
    double side[2][3], across[3];
    for (int corner = 0; corner < 3; corner++)
        for (int i = 0; i < 3; i++)
            corners[corner][i] = (double)places[corner][i];
    for (int i = 0; i < 3; i++) {
        side[0][i] = corners[1][i] - corners[0][i];
        side[1][i] = corners[2][i] - corners[0][i];
    }
    fixture_cross(side[0], side[1], across);
    double length = sqrt(fixture_dot(across, across));
    for (int i = 0; i < 3; i++) /* counter-clockwise about the normal */
        assert_near(across[i] / length, (double)light->plane[i], 1e-5);
    return length / 2;
}

/* What all lights give to a surface, as the G-buffer holds it. */
static inline void fixture_irradiance(const light_data *lights, uint32_t count,
                                      const float position[3], uint32_t packed, double sum[3])
{
    double x[3], n[3];
    float unpacked[3];
    unpack_normal(packed, unpacked);
    for (int k = 0; k < 3; k++) {
        x[k] = (double)position[k];
        n[k] = (double)unpacked[k];
        sum[k] = 0;
    }
    for (uint32_t l = 0; l < count; l++) {
        double corners[3][3];
        light_corners(&lights[l], corners);
        double factor = fixture_form_factor(corners, x, n);
        sum[0] += (double)lights[l].a[3] * factor;
        sum[1] += (double)lights[l].b[3] * factor;
        sum[2] += (double)lights[l].c[3] * factor;
    }
}

#endif
