/* The mathematics of the hull on the device against double precision: form factors, moments, and
 * the window between near and far lights. */
#include "render_fixture.h"

#include "render/hull_private.h"

typedef double vec[3];

static double uniform(uint32_t *seed)
{
    *seed = *seed * 1664525U + 1013904223U;
    return (double)(*seed >> 8) / 16777216.0;
}

/* ---- Light from a triangle, in double -----------------------------------------------------------
 */

/* Lambert's sum over the polygon clipped to the horizon; corners relative to the point. */
static double exact_form_factor(const light_data *l, const float at[3], const float normal[3])
{
    vec corners[3], p[4], n = {(double)normal[0], (double)normal[1], (double)normal[2]};
    const float *from[3] = {l->c, l->b, l->a};
    fixture_unit(n);
    int count = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            corners[i][j] = (double)from[i][j] - (double)at[j];
    for (int i = 0; i < 3; i++) {
        const double *u = corners[i], *v = corners[(i + 1) % 3];
        double a = fixture_dot(u, n), b = fixture_dot(v, n);
        if (a > 0)
            memcpy(p[count++], u, sizeof(vec));
        if ((a > 0) != (b > 0)) {
            for (int j = 0; j < 3; j++)
                p[count][j] = u[j] + a / (a - b) * (v[j] - u[j]);
            count++;
        }
    }
    double sum = 0;
    for (int i = 0; i < count; i++) {
        vec g;
        fixture_cross(p[i], p[(i + 1) % count], g);
        double size = sqrt(fixture_dot(g, g));
        if (size > 0)
            sum += atan2(size, fixture_dot(p[i], p[(i + 1) % count])) * fixture_dot(g, n) / size;
    }
    return sum / (2 * pi);
}

/* Solid angle, first and second moments by midpoints of small triangles. */
static void summed_moments(const light_data *l, const float at[3], double m[10])
{
    enum { PARTS = 200 };
    memset(m, 0, 10 * sizeof *m);
    for (int i = 0; i < PARTS; i++)
        for (int j = 0; j < 2 * (PARTS - i) - 1; j++) {
            double u = (i + (j & 1 ? 2 : 1) / 3.0) / PARTS;
            double v = (j / 2 + (j & 1 ? 2 : 1) / 3.0) / PARTS;
            vec w, plane = {(double)l->plane[0], (double)l->plane[1], (double)l->plane[2]};
            for (int k = 0; k < 3; k++)
                w[k] = (double)l->a[k] + u * ((double)l->b[k] - (double)l->a[k]) +
                       v * ((double)l->c[k] - (double)l->a[k]) - (double)at[k];
            double d2 = fixture_dot(w, w);
            double solid =
                -fixture_dot(w, plane) / sqrt(d2) / d2 * (double)l->plane[3] / (PARTS * PARTS);
            fixture_unit(w);
            double terms[10] = {1,           w[0],        w[1],        w[2],        w[0] * w[0],
                                w[1] * w[1], w[2] * w[2], w[0] * w[1], w[0] * w[2], w[1] * w[2]};
            for (int k = 0; k < 10; k++)
                m[k] += solid * terms[k];
        }
}

typedef struct probe_point {
    float place[4], normal[4];
} probe_point;

typedef struct probe_result {
    float first[4], squares[4], products[4], gradient[4], slope[4];
} probe_result;

static void make_light(light_data *l, const vec corners[3])
{
    vec side[2], n;
    float *to[3] = {l->a, l->b, l->c};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            to[i][j] = (float)corners[i][j];
        to[i][3] = 1;
    }
    for (int j = 0; j < 3; j++) {
        side[0][j] = (double)l->b[j] - (double)l->a[j];
        side[1][j] = (double)l->c[j] - (double)l->a[j];
    }
    fixture_cross(side[0], side[1], n);
    l->plane[3] = (float)(0.5 * sqrt(fixture_dot(n, n)));
    fixture_unit(n);
    for (int j = 0; j < 3; j++)
        l->plane[j] = (float)n[j];
}

/* A triangle and a point before it: any, coplanar with the point's horizon, right beside an edge,
 * tiny, or huge. */
static void make_case(int i, uint32_t *seed, light_data *l, probe_point *p)
{
    vec corners[3], n;
    double size = i % 8 == 1 ? 1e-3 : i % 8 == 2 ? 20 : 1;
    do {
        double far = 3 * size;
        for (int k = 0; k < 3; k++)
            n[k] = 2 * uniform(seed) - 1;
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++)
                corners[c][k] = size * (2 * uniform(seed) - 1);
        for (int k = 0; k < 3; k++)
            p->place[k] = (float)(far * (2 * uniform(seed) - 1));
        if (i % 8 == 3) { /* the light lies in the horizon, or all but */
            n[0] = n[1] = 0;
            n[2] = 1;
            for (int c = 0; c < 3; c++)
                corners[c][2] = (double)p->place[2] + (i % 16 == 3 ? 0 : 1e-4 * c);
        }
        make_light(l, (const vec *)corners);
        if (i % 8 == 4) /* beside an edge */
            for (int k = 0; k < 3; k++)
                p->place[k] = 0.3F * l->a[k] + 0.7F * l->b[k] + 0.02F * l->plane[k];
        double before = 0;
        for (int k = 0; k < 3; k++)
            before += ((double)p->place[k] - (double)l->a[k]) * (double)l->plane[k];
        if (before < 0 && i % 8 != 5) { /* turned to the point */
            vec turned[3];
            memcpy(turned[0], corners[0], sizeof(vec));
            memcpy(turned[1], corners[2], sizeof(vec));
            memcpy(turned[2], corners[1], sizeof(vec));
            make_light(l, (const vec *)turned);
        }
    } while (fixture_dot(n, n) < 0.01 || l->plane[3] < 1e-3F * (float)(size * size));
    fixture_unit(n);
    for (int k = 0; k < 3; k++)
        p->normal[k] = (float)n[k];
    p->place[3] = 2;
    p->normal[3] = 0.1F;
}

static void probe(render_frame *frame, const hull_push *push, const light_data *lights,
                  const probe_point *points, probe_result *results, size_t count)
{
    static const gpu_binding bindings[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER,
                                           GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER};
    gpu_compute *compute = NULL;
    check(render_compute(frame, "test/probe.comp", false, bindings, 4, sizeof *push, &compute));
    gpu_buffer *buffers[3] = {NULL};
    const size_t sizes[3] = {sizeof *lights, sizeof *points, sizeof *results};
    for (int i = 0; i < 3; i++)
        check(gpu_buffer_create(frame->device, count * sizes[i], &buffers[i]));
    memcpy(gpu_buffer_map(buffers[0]), lights, count * sizeof *lights);
    memcpy(gpu_buffer_map(buffers[1]), points, count * sizeof *points);
    gpu_step step = {.name = "probe",
                     .compute = compute,
                     .resources = {frame->view, buffers[0], buffers[1], buffers[2]},
                     .push = push,
                     .groups = {(uint32_t)(count + 63) / 64, 1, 1}};
    check(gpu_run(frame->device, &step, 1, NULL));
    memcpy(results, gpu_buffer_map(buffers[2]), count * sizeof *results);
    for (int i = 0; i < 3; i++)
        gpu_buffer_destroy(buffers[i]);
}

static double before_plane(const light_data *l, const probe_point *p)
{
    double h = 0;
    for (int k = 0; k < 3; k++)
        h += ((double)p->place[k] - (double)l->a[k]) * (double)l->plane[k];
    return h;
}

enum { CASES = 4000 };

typedef struct probed {
    light_data lights[CASES];
    probe_point points[CASES];
    probe_result results[CASES];
    hull_push push;
} probed;

static probed *probe_cases(void **state)
{
    static probed p;
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, (render_options){.width = 16, .height = 16}, &frame);
    uint32_t seed = 1;
    for (int i = 0; i < CASES; i++)
        make_case(i, &seed, &p.lights[i], &p.points[i]);
    p.push = (hull_push){.tau = 0.2F, .tau_width = 3, .near_pixels = 16};
    probe(&frame, &p.push, p.lights, p.points, p.results, CASES);
    render_frame_destroy(&frame);
    return &p;
}

static void form_factors_are_exact(void **state)
{
    const probed *p = probe_cases(state);
    int lit = 0, cut = 0;
    for (int i = 0; i < CASES; i++) {
        double h = before_plane(&p->lights[i], &p->points[i]);
        if (fabs(h - 0.002) < 1e-5)
            continue; /* on the limit itself */
        double expected =
            h < 0.002 ? 0
                      : exact_form_factor(&p->lights[i], p->points[i].place, p->points[i].normal);
        double found = (double)p->results[i].squares[3];
        if (!(fabs(found - expected) <= 1e-5))
            fail_msg("case %d: %.9g, expected %.9g", i, found, expected);
        lit += expected > 1e-6;
        vec first = {(double)p->results[i].first[0], (double)p->results[i].first[1],
                     (double)p->results[i].first[2]};
        vec n = {(double)p->points[i].normal[0], (double)p->points[i].normal[1],
                 (double)p->points[i].normal[2]};
        cut += expected > 1e-4 && fabs(fixture_dot(first, n) / pi - expected) > 1e-4;
    }
    assert_true(lit > CASES / 4 && cut > CASES / 50); /* the cases are worth something */
}

static void moments_are_integrals(void **state)
{
    const probed *p = probe_cases(state);
    int compared = 0;
    for (int i = 0; i < CASES && compared < 60; i++) {
        if (before_plane(&p->lights[i], &p->points[i]) < 0.1 || i % 8 == 2)
            continue; /* where midpoints are exact enough */
        double m[10];
        summed_moments(&p->lights[i], p->points[i].place, m);
        const probe_result *r = &p->results[i];
        const float found[10] = {r->first[3],    r->first[0],   r->first[1],   r->first[2],
                                 r->squares[0],  r->squares[1], r->squares[2], r->products[0],
                                 r->products[1], r->products[2]};
        for (int k = 0; k < 10; k++)
            if (!(fabs((double)found[k] - m[k]) <= 2e-4 * m[0] + 2e-6))
                fail_msg("case %d, moment %d: %.9g, expected %.9g", i, k, (double)found[k], m[k]);
        compared++;
    }
    assert_int_equal(compared, 60);
}

/* The near weight is between 0 and 1, its gradient that of differences. */
static void near_weight_is_a_smooth_window(void **state)
{
    const probed *p = probe_cases(state);
    static probed q;
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, (render_options){.width = 16, .height = 16}, &frame);
    view_data view;
    view_fill(&f.scene.camera, 16, 16, &view);
    const float step = 1e-3F;
    for (int axis = 0; axis < 3; axis++) {
        memcpy(&q, p, sizeof q);
        for (int i = 0; i < CASES; i++) { /* a step aside, and what it does to the view depth */
            q.points[i].place[axis] += step;
            q.points[i].place[3] += step * view.forward[axis];
        }
        probe(&frame, &q.push, q.lights, q.points, q.results, CASES);
        int inside = 0;
        for (int i = 0; i < CASES; i++) {
            double w = (double)p->results[i].products[3], v = (double)q.results[i].products[3];
            double middle = 0.5 * (double)(p->results[i].slope[axis] + q.results[i].slope[axis]);
            if (!(w >= 0 && w <= 1))
                fail_msg("case %d: weight %g", i, w);
            if (w <= 0.01 || w >= 0.99 || before_plane(&p->lights[i], &p->points[i]) < 0.05 ||
                p->lights[i].plane[3] < 1e-2F)
                continue;
            inside++;
            if (!(fabs(v - w - (double)step * middle) <= 2e-5 + 0.05 * fabs(v - w)))
                fail_msg("case %d, axis %d: %.6g, by its gradient %.6g", i, axis, v - w,
                         (double)step * middle);
        }
        assert_true(inside > 20);
    }
    render_frame_destroy(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(form_factors_are_exact),
        cmocka_unit_test(moments_are_integrals),
        cmocka_unit_test(near_weight_is_a_smooth_window),
    };
    return cmocka_run_group_tests(tests, open_device, close_device);
}
