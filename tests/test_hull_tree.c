/* The tree over the lights: sums and bounds of its nodes against the lights below them, and what a
 * descent takes against all lights. */
#include "render_fixture.h"

#include "render/hull_private.h"

enum { MOST = 4096 };
static const size_t counts[] = {0, 1, 2, 3, 5, 257, MOST};
enum { COUNTS = sizeof counts / sizeof *counts };

static light_data lights[MOST];
static light_node nodes[2 * MOST], again[2 * MOST];

static double uniform(uint32_t *seed)
{
    *seed = *seed * 1664525U + 1013904223U;
    return (double)(*seed >> 8) / 16777216.0;
}

/* Triangles on the floor, on a wall and on a ball; some dark, some at one place. */
static void make_lights(size_t count)
{
    uint32_t seed = 7;
    for (size_t i = 0; i < count; i++) {
        light_data *l = &lights[i];
        double n[3] = {0, 0, 0},
               c[3] = {4 * uniform(&seed), 4 * uniform(&seed), 4 * uniform(&seed)};
        size_t kind = i % 7;
        if (kind < 4) {
            n[kind < 3 ? 1 : 0] = 1;
            c[kind < 3 ? 1 : 0] = 0;
        } else {
            for (int k = 0; k < 3; k++)
                n[k] = 2 * uniform(&seed) - 1;
            fixture_unit(n);
            for (int k = 0; k < 3; k++)
                c[k] = 2 + 0.5 * n[k];
        }
        if (i % 11 == 10) /* where the light before is */
            for (int k = 0; k < 3; k++)
                c[k] = (double)lights[i - 1].a[k];
        double axis[3] = {0.3, 0.5, 0.8}, s[3], t[3], size = 0.02 + 0.05 * uniform(&seed);
        fixture_cross(axis, n, s);
        fixture_unit(s);
        fixture_cross(n, s, t);
        float *const corners[3] = {l->a, l->b, l->c};
        for (int j = 0; j < 3; j++) {
            for (int k = 0; k < 3; k++)
                corners[j][k] = (float)(c[k] + size * (cos(2 * pi * j / 3) * s[k] +
                                                       sin(2 * pi * j / 3) * t[k]));
            corners[j][3] = i % 13 == 12 ? 0 : (float)(1 + uniform(&seed));
        }
        for (int k = 0; k < 3; k++)
            l->plane[k] = (float)n[k];
        l->plane[3] = (float)(0.75 * sqrt(3) * size * size);
    }
}

static double away(const float a[3], const float b[3])
{
    double square = 0;
    for (int k = 0; k < 3; k++)
        square += ((double)a[k] - (double)b[k]) * ((double)a[k] - (double)b[k]);
    return sqrt(square);
}

static double along(const float a[3], const float from[3], const float n[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += ((double)a[k] - (double)from[k]) * (double)n[k];
    return sum;
}

static void check_light(const light_node *n, const light_data *l)
{
    float centre[3];
    for (int k = 0; k < 3; k++)
        centre[k] = (l->a[k] + l->b[k] + l->c[k]) / 3;
    const float *corners[3] = {l->a, l->b, l->c};
    for (int i = 0; i < 3; i++)
        assert_true(away(n->middle, corners[i]) <= (double)n->radius + 1e-6);
    assert_true(away(n->axis, l->plane) <= (double)n->spread + 1e-6);
    assert_true(fabs(along(n->middle, l->a, l->plane)) <= (double)n->slack + 1e-6);
    double off = along(centre, n->middle, n->axis) / (double)n->radius;
    assert_true(off * off <= (double)n->bend + 1e-6);
    double disc = sqrt((double)l->plane[3] / pi);
    assert_true(away(n->middle, centre) + disc <= (double)n->reach + 1e-6);
    assert_true(l->plane[3] >= n->smallest);
}

static void check_node(size_t node)
{
    const light_node *n = &nodes[node];
    double flux[3] = {0, 0, 0}, power = 0, strongest = 0, middle[3] = {0, 0, 0};
    for (size_t i = node; i < n->skip; i++) {
        if (nodes[i].index == UINT32_MAX)
            continue;
        const light_data *l = &lights[nodes[i].index];
        double area = (double)l->plane[3], zero = along(l->plane, (float[3]){0, 0, 0}, n->axis);
        double mean = ((double)l->a[3] + (double)l->b[3] + (double)l->c[3]) / 3 * area;
        check_light(n, l);
        for (int k = 0; k < 3; k++) {
            flux[k] += zero * area * (double)(k == 0 ? l->a : k == 1 ? l->b : l->c)[3];
            middle[k] += mean * ((double)l->a[k] + (double)l->b[k] + (double)l->c[k]) / 3;
        }
        power += mean;
        strongest = fmax(strongest, mean);
    }
    const light_data *l = &n->light;
    assert_near(n->power, power, 1e-5 * (power + 1e-9));
    assert_near(n->strongest, strongest, 2e-5 * (power + 1e-9));
    for (int k = 0; k < 3; k++) {
        const float *corner = k == 0 ? l->a : k == 1 ? l->b : l->c;
        assert_near((double)corner[3] * (double)l->plane[3], fmax(flux[k], 0), 1e-5 * power + 1e-9);
        if (power > 0)
            assert_near(((double)l->a[k] + (double)l->b[k] + (double)l->c[k]) / 3,
                        middle[k] / power, 1e-5);
    }
    /* the corners turn around the normal, and enclose the area */
    double side[2][3], across[3], n3[3];
    for (int k = 0; k < 3; k++) {
        side[0][k] = (double)l->b[k] - (double)l->a[k];
        side[1][k] = (double)l->c[k] - (double)l->a[k];
        n3[k] = (double)l->plane[k];
    }
    fixture_cross(side[0], side[1], across);
    assert_near(0.5 * fixture_dot(across, n3), l->plane[3], 1e-3 * (double)l->plane[3] + 1e-6);
}

static void nodes_hold_what_is_below(void **state)
{
    (void)state;
    for (int c = 0; c < COUNTS; c++)
        for (int hierarchy = 0; hierarchy < 2; hierarchy++) {
            make_lights(counts[c]);
            size_t size = light_tree_build(lights, counts[c], hierarchy, nodes);
            assert_true(size <= 2 * counts[c] && size >= counts[c]);
            assert_true(hierarchy || size == counts[c]);
            assert_int_equal(light_tree_build(lights, counts[c], hierarchy, again), size);
            assert_memory_equal(nodes, again, size * sizeof *nodes);
            uint8_t seen[MOST] = {0};
            for (size_t i = 0; i < size; i++) {
                assert_true(nodes[i].skip > i && nodes[i].skip <= size);
                assert_true((nodes[i].skip == i + 1) == (nodes[i].index != UINT32_MAX));
                if (nodes[i].index != UINT32_MAX)
                    assert_int_equal(seen[nodes[i].index]++, 0);
                int below = 0; /* nodes right below, which end where this one does */
                size_t at = i + 1;
                for (; at < nodes[i].skip; at = nodes[at].skip)
                    below++;
                assert_true(below <= 4 && below != 1 && at == nodes[i].skip);
                check_node(i);
            }
        }
}

/* ---- Descents ----------------------------------------------------------------------------------
 */

typedef struct point {
    float place[4], normal[4];
} point;

enum { POINTS = 128 };

typedef struct descent {
    uint32_t taken[POINTS * (2 * MOST + 1)];
    float sums[POINTS][4];
} descent;

static void descend(render_frame *frame, const hull_push *push, const point *points, descent *out)
{
    gpu_binding bindings[5];
    for (int i = 0; i < 5; i++)
        bindings[i] = i == 1 ? GPU_FETCHED : GPU_STORAGE_BUFFER;
    gpu_compute *compute = NULL;
    gpu_buffer *buffers[3] = {NULL};
    gpu_image *tree = NULL;
    static light_node texels[(2 * MOST / LIGHT_NODES_ACROSS + 1) * LIGHT_NODES_ACROSS];
    memcpy(texels, nodes, sizeof *nodes * push->nodes_end);
    size_t words = (size_t)POINTS * (push->nodes_end + 1);
    const size_t sizes[3] = {POINTS * sizeof *points, 4 * words, sizeof out->sums};
    check(render_compute(frame, "test/descent.comp", false, bindings, 5, sizeof *push, &compute));
    check(gpu_image_create(frame->device, GPU_RGBA32U, LIGHT_NODE_TEXELS * LIGHT_NODES_ACROSS,
                           sizeof texels / sizeof *texels / LIGHT_NODES_ACROSS, &tree));
    check(gpu_image_write(tree, texels));
    for (int i = 0; i < 3; i++)
        check(gpu_buffer_create(frame->device, sizes[i], &buffers[i]));
    memcpy(gpu_buffer_map(buffers[0]), points, sizes[0]);
    gpu_step step = {.name = "descent",
                     .compute = compute,
                     .resources = {frame->view, tree, buffers[0], buffers[1], buffers[2]},
                     .push = push,
                     .groups = {POINTS / 64, 1, 1}};
    check(gpu_run(frame->device, &step, 1, NULL));
    memcpy(out->taken, gpu_buffer_map(buffers[1]), sizes[1]);
    memcpy(out->sums, gpu_buffer_map(buffers[2]), sizes[2]);
    gpu_compute_destroy(compute);
    gpu_image_destroy(tree);
    for (int i = 0; i < 3; i++)
        gpu_buffer_destroy(buffers[i]);
}

/* Every light once; none but those that the point is behind of. */
static void check_cut(const descent *d, int i, size_t size, size_t count, const point *p)
{
    static uint8_t covered[MOST];
    memset(covered, 0, sizeof covered);
    const uint32_t *taken = d->taken + (size_t)i * (size + 1);
    for (uint32_t j = 1; j <= taken[0]; j++)
        for (size_t at = taken[j]; at < nodes[taken[j]].skip; at++)
            if (nodes[at].index != UINT32_MAX)
                assert_int_equal(covered[nodes[at].index]++, 0);
    for (size_t l = 0; l < count; l++)
        assert_true(covered[l] || along(p->place, lights[l].a, lights[l].plane) < 0.0021);
}

static void descents_take_every_light_once(void **state)
{
    static descent cut, whole;
    static point points[POINTS];
    fixture f;
    render_frame frame;
    fixture_make(&f);
    make_frame(state, &f, (render_options){.width = 16, .height = 16}, &frame);
    uint32_t seed = 3;
    size_t most = 0;
    for (int c = 0; c < COUNTS; c++) {
        make_lights(counts[c]);
        size_t size = light_tree_build(lights, counts[c], true, nodes);
        hull_push push = {
            .tau = 0.2F, .tau_width = 3, .near_pixels = 0.5F, .nodes_end = (uint32_t)size};
        for (int i = 0; i < POINTS; i++) {
            double n[3] = {uniform(&seed) - 0.5, uniform(&seed) - 0.5, uniform(&seed) - 0.5};
            fixture_unit(n);
            for (int k = 0; k < 3; k++) {
                points[i].place[k] = (float)(4 * uniform(&seed));
                points[i].normal[k] = (float)n[k];
            }
            points[i].place[3] = 2;
            points[i].normal[3] = 0.2F;
        }
        descend(&frame, &push, points, &whole); /* merge is 0: light by light */
        push.merge = 0.005F;
        descend(&frame, &push, points, &cut);
        double square = 0;
        for (int i = 0; i < POINTS; i++) {
            check_cut(&cut, i, size, counts[c], &points[i]);
            check_cut(&whole, i, size, counts[c], &points[i]);
            for (int k = 0; k < 3; k++)
                square += pow((double)cut.sums[i][k] - (double)whole.sums[i][k], 2) / 3 / POINTS;
            if (c == COUNTS - 1 && cut.taken[(size_t)i * (size + 1)] > most)
                most = cut.taken[(size_t)i * (size + 1)];
        }
        assert_true(sqrt(square) <= 2 * 0.005 * 0.2);
    }
    assert_true(most < MOST / 4); /* of thousands a few stand for all */
    render_frame_destroy(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_hold_what_is_below),
        cmocka_unit_test_setup_teardown(descents_take_every_light_once, open_device, close_device),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
