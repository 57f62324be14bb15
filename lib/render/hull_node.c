/* A node of the tree over the lights: the triangle that stands for the lights below it, and bounds
 * of them. */
#include "hull_tree.h"

#include <float.h>
#include <math.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static const float *corner(const light_data *l, int i)
{
    return i == 0 ? l->a : i == 1 ? l->b : l->c;
}

void light_centre(const light_data *l, double c[3])
{
    for (int k = 0; k < 3; k++)
        c[k] = ((double)l->a[k] + (double)l->b[k] + (double)l->c[k]) / 3;
}

/* Two unit vectors across a third one. */
static void basis(const double n[3], double s[3], double t[3])
{
    int least = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(n[i]) < fabs(n[least]))
            least = i;
    int j = (least + 1) % 3, k = (least + 2) % 3;
    double size = sqrt(n[j] * n[j] + n[k] * n[k]);
    s[least] = 0;
    s[j] = n[k] / size;
    s[k] = -n[j] / size;
    for (int i = 0; i < 3; i++)
        t[i] = n[(i + 1) % 3] * s[(i + 2) % 3] - n[(i + 2) % 3] * s[(i + 1) % 3];
}

typedef struct sums {
    double middle[3], axis[3], weight;
} sums;

/* Where, and in which direction, the lights shine: weighted by flux, or by area where they are
 * dark. */
static sums sum(const light_data *lights, const light_emitter *emitters, size_t count)
{
    sums s = {.weight = 0};
    bool dark = true;
    for (size_t i = 0; i < count; i++)
        dark = dark && emitters[i].power <= 0;
    for (size_t i = 0; i < count; i++) {
        const light_data *l = &lights[emitters[i].index];
        double c[3], weight = dark ? (double)l->plane[3] : emitters[i].power;
        light_centre(l, c);
        s.weight += weight;
        for (int k = 0; k < 3; k++) {
            s.middle[k] += weight * c[k];
            s.axis[k] += weight * (double)l->plane[k];
        }
    }
    const light_data *any = &lights[emitters[0].index];
    if (s.weight <= 0)
        light_centre(any, s.middle);
    else
        for (int k = 0; k < 3; k++)
            s.middle[k] /= s.weight;
    double size = sqrt(dot(s.axis, s.axis));
    for (int k = 0; k < 3; k++)
        s.axis[k] = size > 1e-6 * s.weight ? s.axis[k] / size : (double)any->plane[k];
    return s;
}

/* The triangle that stands for the lights: with their flux along the axis; its covariance is R^2/8
 * for a radius R of the circle through the corners, along each of its axes. */
static void stand_for(const light_data *lights, const light_emitter *emitters, size_t count,
                      const sums *s, bool turned, light_data *to)
{
    double u[3], v[3], uu = 0, vv = 0, uv = 0, flux[3] = {0, 0, 0}, weights = 0;
    basis(s->axis, u, v);
    for (size_t i = 0; i < count; i++) {
        const light_data *l = &lights[emitters[i].index];
        double c[3], normal[3] = {(double)l->plane[0], (double)l->plane[1], (double)l->plane[2]};
        double along = dot(normal, s->axis) * (double)l->plane[3];
        light_centre(l, c);
        for (int k = 0; k < 3; k++)
            flux[k] += along * (double)corner(l, k)[3];
        double weight = emitters[i].power > 0 ? emitters[i].power : 1e-9 * (double)l->plane[3];
        weights += weight;
        for (int k = -1; k < 3; k++) { /* the centre; corners around the centre, 1/12 each */
            double r[3], share = k < 0 ? weight : weight / 12;
            for (int j = 0; j < 3; j++)
                r[j] = k < 0 ? c[j] - s->middle[j] : (double)corner(l, k)[j] - c[j];
            double x = dot(r, u), y = dot(r, v);
            uu += share * x * x;
            vv += share * y * y;
            uv += share * x * y;
        }
    }
    weights = fmax(weights, DBL_MIN);
    double angle = 0.5 * atan2(2 * uv, uu - vv), cosine = cos(angle), sine = sin(angle);
    double half = 0.5 * (uu + vv), apart = sqrt(0.25 * (uu - vv) * (uu - vv) + uv * uv);
    double long_side = sqrt(8 * fmax(half + apart, 1e-12) / weights);
    double short_side = fmax(sqrt(8 * fmax(half - apart, 0) / weights), 1e-3 * long_side);
    double area = 0.75 * sqrt(3) * long_side * short_side;
    float *const corners[3] = {to->a, to->b, to->c};
    for (int k = 0; k < 3; k++) {
        double turn = 2.0943951023931953 * k + (turned ? 3.1415926535897931 : 0);
        double x = long_side * cos(turn), y = short_side * sin(turn);
        for (int j = 0; j < 3; j++)
            corners[k][j] = (float)(s->middle[j] + x * (cosine * u[j] + sine * v[j]) +
                                    y * (cosine * v[j] - sine * u[j]));
        corners[k][3] = (float)(fmax(flux[k], 0) / area);
        to->plane[k] = (float)s->axis[k];
    }
    to->plane[3] = (float)area;
}

static double away(const double a[3], const float b[3])
{
    double square = 0;
    for (int k = 0; k < 3; k++)
        square += (a[k] - (double)b[k]) * (a[k] - (double)b[k]);
    return sqrt(square);
}

/* Bounds, a little wider than they are: what follows computes in float. */
static void bound(const light_data *lights, const light_emitter *emitters, size_t count,
                  const sums *s, light_node *node)
{
    double radius = 0, spread = 0, off = 0, slack = 0, reach = 0, power = 0, strongest = 0;
    double smallest = DBL_MAX;
    for (size_t i = 0; i < count; i++) {
        const light_data *l = &lights[emitters[i].index];
        double c[3], r[3], from_plane = 0, along = 0;
        light_centre(l, c);
        for (int k = 0; k < 3; k++) {
            radius = fmax(radius, away(s->middle, corner(l, k)));
            r[k] = s->middle[k] - c[k];
            along += r[k] * s->axis[k];
            from_plane += (s->middle[k] - (double)l->a[k]) * (double)l->plane[k];
        }
        spread = fmax(spread, away(s->axis, l->plane));
        off = fmax(off, fabs(along));
        slack = fmax(slack, fabs(from_plane));
        reach = fmax(reach, sqrt(dot(r, r)) + sqrt((double)l->plane[3] / 3.14159265358979323846));
        power += emitters[i].power;
        strongest = fmax(strongest, emitters[i].power);
        smallest = fmin(smallest, (double)l->plane[3]);
    }
    const double wider = count > 1 ? 1.00001 : 1;
    node->radius = (float)(wider * radius);
    node->spread = count > 1 ? (float)(wider * spread + 1e-6) : 0;
    node->bend = radius > 0 ? (float)(off / radius * (off / radius)) : 0;
    node->slack = (float)(wider * slack);
    node->reach = (float)(wider * reach);
    node->power = (float)power;
    node->strongest = (float)(wider * strongest);
    node->smallest = (float)(smallest / wider);
}

void light_node_make(const light_data *lights, const light_emitter *emitters, size_t count,
                     bool turned, light_node *node)
{
    sums s = sum(lights, emitters, count);
    for (int k = 0; k < 3; k++) {
        node->middle[k] = (float)s.middle[k];
        node->axis[k] = (float)s.axis[k];
    }
    bound(lights, emitters, count, &s, node);
    node->index = UINT32_MAX;
    if (count == 1) {
        node->index = emitters[0].index;
        node->light = lights[node->index];
    } else {
        stand_for(lights, emitters, count, &s, turned, &node->light);
    }
}
