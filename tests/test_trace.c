/* Rays against triangles on the device, ray by ray against Embree's own tracer. Where the two
 * differ the ray must pass within a millionth of the scene's size of some triangle's edge, or
 * within a few roundings of its plane. */
#include "trace_rays.h"

#include <time.h>

#include "embree.h"

/* ---- Tests --------------------------------------------------------------------------- */

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Every other ray is an adversary: aimed at an edge or a corner, in a plane, or begun on a surface,
 * where a rounding decides. Of those a fifth may differ, of the others one in a thousand. */
static void compare(fixture *f, const render_scene *scene, const char *name)
{
    render_tracer tracer;
    must(render_tracer_create(f->device, scene, &tracer));
    ray_data *rays = make_rays(scene);
    hit_data *nearest = malloc(RAYS * sizeof *nearest), *any = malloc(RAYS * sizeof *any);
    double seconds = trace(f, &tracer, rays, RAYS, false, nearest);
    double seconds_any = trace(f, &tracer, rays, RAYS, true, any);
    embree_scene embree = embree_open(scene);
    double size = size_of(scene), begin, embree_seconds = 0;
    int differ[2] = {0, 0}, hits = 0;
    for (int i = 0; i < RAYS; i++) {
        float at;
        begin = now();
        uint32_t expected =
            embree_closest(&embree, rays[i].origin, rays[i].direction, rays[i].far, &at);
        embree_seconds += now() - begin;
        bool hit = nearest[i].triangle != UINT32_MAX;
        assert_int_equal(hit, any[i].triangle != UINT32_MAX);
        hits += hit;
        double step = sqrt((double)rays[i].direction[0] * (double)rays[i].direction[0] +
                           (double)rays[i].direction[1] * (double)rays[i].direction[1] +
                           (double)rays[i].direction[2] * (double)rays[i].direction[2]);
        bool same = hit == (expected != UINT32_MAX) &&
                    (!hit || nearest[i].triangle == expected ||
                     fabs((double)nearest[i].at - (double)at) * step < 1e-5 * size);
        if (same)
            continue;
        differ[i % 2]++;
        if (!excused(scene, &rays[i], 2e-6 * size))
            fail_msg("%s, ray %d: triangle %u at %g, Embree %u at %g, far from every edge", name, i,
                     nearest[i].triangle, (double)nearest[i].at, expected, (double)at);
    }
    printf(
        "%s: %d of %d rays hit; %d random ones and %d adversaries differ from Embree, each at an "
        "edge or an end; speed: nearest %.3f, any %.3f of one core of Embree\n",
        name, hits, RAYS, differ[0], differ[1], embree_seconds / seconds,
        embree_seconds / seconds_any);
    assert_true(hits > RAYS / 20);
    assert_true(differ[0] <= RAYS / 2 / 1000);
    assert_true(differ[1] <= RAYS / 2 / 5);
    embree_close(&embree);
    free(rays);
    free(nearest);
    free(any);
    render_tracer_destroy(&tracer);
}

static void rays_hit_what_embree_hits(void **state)
{
    (void)state;
    fixture f = open_fixture();
    render_scene box = read_scene("box");
    compare(&f, &box, "box");
    render_scene_free(&box);
    const struct {
        size_t triangles;
        float size;
    } soups[] = {{40, 0.8f}, {1000, 0.2f}, {1000, 0.01f}};
    for (size_t i = 0; i < sizeof soups / sizeof *soups; i++) {
        char name[64];
        snprintf(name, sizeof name, "%zu triangles of size %g", soups[i].triangles,
                 (double)soups[i].size);
        render_scene scene = soup(soups[i].triangles, soups[i].size);
        compare(&f, &scene, name);
        render_scene_free(&scene);
    }
    close_fixture(&f);
}

/* A closed surface: from inside, whatever the ray is aimed at, it cannot leave. */
static void a_closed_surface_has_no_gaps(void **state)
{
    (void)state;
    enum { ROUND = 24, HIGH = 13, COUNT = 20000 };
    fixture f = open_fixture();
    render_scene scene = {.vertex_count = ROUND * HIGH,
                          .positions = malloc(sizeof(float) * 3 * ROUND * HIGH),
                          .indices = malloc(sizeof(uint32_t) * 6 * ROUND * HIGH)};
    for (int j = 0; j < HIGH; j++)
        for (int i = 0; i < ROUND; i++) {
            double up = 3.14159265358979 * j / (HIGH - 1), round = 6.28318530717959 * i / ROUND;
            double r = j % (HIGH - 1) ? sin(up) : 0; /* the poles are many equal corners */
            float p[3] = {(float)(10 + r * cos(round)), (float)cos(up), (float)(r * sin(round))};
            memcpy(scene.positions + 3 * (j * ROUND + i), p, sizeof p);
            if (j + 1 == HIGH)
                continue;
            uint32_t a = (uint32_t)(j * ROUND + i), b = (uint32_t)(j * ROUND + (i + 1) % ROUND);
            uint32_t two[6] = {a, b, a + ROUND, b, b + ROUND, a + ROUND};
            memcpy(scene.indices + 3 * scene.triangle_count, two, sizeof two);
            scene.triangle_count += 2;
        }
    render_tracer tracer;
    must(render_tracer_create(f.device, &scene, &tracer));
    ray_data *rays = calloc(COUNT, sizeof *rays);
    hit_data *hits = malloc(COUNT * sizeof *hits);
    for (int i = 0; i < COUNT; i++) {
        for (int k = 0; k < 3; k++)
            rays[i].origin[k] = (k == 0 ? 10 : 0) + 0.8f * (uniform() - 0.5f);
        direction(rays[i].direction);
        rays[i].far = 1e30f;
        float a = uniform(), target[3];
        size_t t = (size_t)((float)scene.triangle_count * 0.999999f * a);
        a = uniform();
        weigh(&scene, t, i % 4 == 1 ? (float[3]){a, 1 - a, 0} : (float[3]){1, 0, 0}, target);
        if (i % 4 == 1 || i % 4 == 2) /* an edge, a corner */
            towards(&rays[i], target);
    }
    trace(&f, &tracer, rays, COUNT, true, hits);
    for (int i = 0; i < COUNT; i++)
        if (hits[i].triangle == UINT32_MAX)
            fail_msg("ray %d leaves a closed surface", i);
    free(rays);
    free(hits);
    render_tracer_destroy(&tracer);
    render_scene_free(&scene);
    close_fixture(&f);
}

static void no_triangle_and_one(void **state)
{
    (void)state;
    fixture f = open_fixture();
    ray_data rays[2] = {{.origin = {0.2f, 0.2f, 1}, .far = 1e30f, .direction = {0, 0, -2}},
                        {.origin = {0.8f, 0.8f, 1}, .far = 1e30f, .direction = {0, 0, -2}}};
    hit_data hits[2];
    render_tracer tracer;
    render_scene scene = {0};
    must(render_tracer_create(f.device, &scene, &tracer));
    trace(&f, &tracer, rays, 2, false, hits);
    assert_int_equal(hits[0].triangle, UINT32_MAX);
    render_tracer_destroy(&tracer);
    float positions[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    uint32_t indices[3] = {0, 1, 2};
    scene = (render_scene){
        .vertex_count = 3, .triangle_count = 1, .positions = positions, .indices = indices};
    must(render_tracer_create(f.device, &scene, &tracer));
    for (int any = 0; any < 2; any++) {
        trace(&f, &tracer, rays, 2, any, hits);
        assert_int_equal(hits[0].triangle, 0);
        assert_true(any || hits[0].at == 0.5f);
        assert_int_equal(hits[1].triangle, UINT32_MAX);
    }
    render_tracer_destroy(&tracer);
    close_fixture(&f);
}

/* Every triangle is in one leaf, every box holds what is below it, twice the same tree. */
static uint32_t check_node(const render_bvh *bvh, uint32_t node, const float *low,
                           const float *high, uint32_t depth)
{
    assert_true(depth <= RENDER_BVH_DEPTH);
    if (node == RENDER_BVH_EMPTY)
        return 0;
    if (node & RENDER_BVH_LEAF) {
        uint32_t first = (node & ~RENDER_BVH_LEAF) >> 3, count = (node & 7) + 1;
        for (uint32_t t = first; t < first + count; t++)
            for (int i = 0; i < 9; i++) {
                float x = bvh->triangles[12 * t + (uint32_t)(i / 3 * 4 + i % 3)];
                assert_true(x >= low[i % 3] && x <= high[i % 3]);
            }
        return count;
    }
    assert_true(node >= 1 && node < bvh->node_count);
    const uint32_t *p = bvh->nodes + 8 * node;
    float grid[8], corners[2][2][3];
    memcpy(grid, bvh->nodes, sizeof grid);
    for (int i = 0; i < 12; i++)
        corners[i / 6][i % 2][i / 2 % 3] =
            grid[i / 2 % 3] + (float)(p[i / 2] >> i % 2 * 16 & 0xffff) * grid[3 + i / 2 % 3];
    return check_node(bvh, p[6], corners[0][0], corners[0][1], depth + 1) +
           check_node(bvh, p[7], corners[1][0], corners[1][1], depth + 1);
}

static void the_tree_holds_everything(void **state)
{
    (void)state;
    render_scene scene = soup(5000, 0.1f);
    for (size_t i = 0; i < 9 * 1000; i++)
        scene.positions[i] = scene.positions[i % 9]; /* a thousand times the same triangle */
    render_bvh bvh, again;
    must(render_bvh_build(&scene, &bvh));
    must(render_bvh_build(&scene, &again));
    assert_int_equal(bvh.triangle_count, 5000);
    assert_int_equal(check_node(&bvh, bvh.root, NULL, NULL, 0), 5000);
    unsigned char *seen = calloc(5000, 1);
    for (size_t t = 0; t < 5000; t++) {
        uint32_t number;
        memcpy(&number, bvh.triangles + 12 * t + 3, 4);
        assert_true(number < 5000 && !seen[number]);
        seen[number] = 1;
    }
    assert_int_equal(bvh.node_count, again.node_count);
    assert_memory_equal(bvh.nodes, again.nodes, 32 * bvh.node_count);
    assert_memory_equal(bvh.triangles, again.triangles, 48 * bvh.triangle_count);
    free(seen);
    render_bvh_free(&bvh);
    render_bvh_free(&again);
    render_scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_tree_holds_everything),
        cmocka_unit_test(no_triangle_and_one),
        cmocka_unit_test(a_closed_surface_has_no_gaps),
        cmocka_unit_test(rays_hit_what_embree_hits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
