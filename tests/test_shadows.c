/* Area lights with shadows: their points, ground truth against Embree's rays, the pipelines against
 * ground truth. */
#include "multires_fixture.h"

#include "embree.h"

enum { WIDTH = 96, HEIGHT = 70, PIXELS = WIDTH * HEIGHT };

/* ---- Points on lights ---------------------------------------------------------------- */

static void points_are_stratified(void **state)
{
    (void)state;
    render_area_light square = {.corner_count = 4,
                                .corners = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}};
    float points[SHADOWS_POINTS][4];
    shadows_points(&square, 0.25, points);
    uint64_t cells = 0, columns = 0, rows = 0;
    for (int set = 0; set < 4; set++) {
        uint32_t coarse = 0;
        for (int i = 16 * set; i < 16 * set + 16; i++) {
            int x = (int)points[i][0], y = (int)points[i][1];
            cells |= (uint64_t)1 << (8 * y + x);
            coarse |= 1u << (y / 2 * 4 + x / 2);
            columns |= (uint64_t)1 << (int)(8 * points[i][0]);
            rows |= (uint64_t)1 << (int)(8 * points[i][1]);
            assert_true(points[i][2] == 0.25F);
        }
        assert_int_equal(coarse, 0xffff);
    }
    assert_true(cells == UINT64_MAX && columns == UINT64_MAX && rows == UINT64_MAX);
}

static void points_cover_any_polygon_evenly(void **state)
{
    (void)state;
    const render_area_light lights[] = {
        {.corner_count = 3, .corners = {{0, 0, 1}, {3, 0, 1}, {0, 6, 1}}},
        {.corner_count = 4, .corners = {{0, 0, 1}, {4, 0, 1}, {3, 2, 1}, {0, 2, 1}}},
        {.corner_count = 5, .corners = {{0, 0, 1}, {2, 0, 1}, {3, 1, 1}, {1, 3, 1}, {0, 1, 1}}}};
    for (size_t l = 0; l < sizeof lights / sizeof *lights; l++) {
        const render_area_light *light = &lights[l];
        double mean[2] = {0}, centroid[2] = {0}, area = 0;
        float points[SHADOWS_POINTS][4];
        shadows_points(light, 0, points);
        for (int i = 0; i < SHADOWS_POINTS; i++)
            for (int k = 0; k < 2; k++)
                mean[k] += (double)points[i][k] / SHADOWS_POINTS;
        for (int i = 1; i + 1 < light->corner_count; i++) {
            const double *a = light->corners[0], *b = light->corners[i], *c = light->corners[i + 1];
            double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            area += twice;
            for (int k = 0; k < 2; k++)
                centroid[k] += twice * (a[k] + b[k] + c[k]) / 3;
        }
        for (int k = 0; k < 2; k++)
            assert_true(fabs(mean[k] - centroid[k] / area) < 0.02 * 6);
        for (int i = 0; i < SHADOWS_POINTS; i++)
            for (int e = 0; e < light->corner_count; e++) {
                const double *a = light->corners[e],
                             *b = light->corners[(e + 1) % light->corner_count];
                assert_true((b[0] - a[0]) * ((double)points[i][1] - a[1]) -
                                (b[1] - a[1]) * ((double)points[i][0] - a[0]) >
                            -1e-6);
            }
    }
}

/* ---- Ground truth -------------------------------------------------------------------- */

/* Share of a light that a pixel sees, by 64 rays of Embree; weights as in area.glsl. */
static double share(const fixture *f, const embree_scene *embree, const render_area_light *light,
                    size_t at)
{
    const float *p = f->position + 4 * at;
    float points[SHADOWS_POINTS][4], origin[3];
    double n[3], seen = 0, all = 0;
    shadow_rays(f, light, at, points, n, origin);
    for (int i = 0; i < SHADOWS_POINTS; i++) {
        float from[3];
        double facing = 0;
        for (int k = 0; k < 3; k++) {
            from[k] = points[i][k] - p[k];
            facing -= (double)from[k] * n[k];
        }
        double weight = fmax(dot(from, f->normal[at]), 0) * fmax(facing, 0) /
                        (dot(from, from) * dot(from, from));
        if (dot(from, f->face[at]) <= 0)
            weight = 0;
        all += weight;
        if (weight > 0 && embree_is_open(embree, origin, points[i]))
            seen += weight;
    }
    return seen > 0 ? seen / all : 0;
}

/* With one light at a time: the shadowed image over the one without is the share that is seen. */
static void ground_truth_is_what_embree_sees(void **state)
{
    (void)state;
    fixture f;
    fixture_open(&f, "box_area", WIDTH, HEIGHT);
    render_statistics statistics;
    embree_scene embree = embree_open(&f.scene);
    render_scene empty = f.scene;
    size_t lights = f.scene.area_light_count;
    render_area_light all[2] = {f.scene.area_lights[0], f.scene.area_lights[1]};
    assert_int_equal(lights, 2);
    for (size_t l = 0; l < 2; l++) {
        f.scene.area_light_count = 1;
        f.scene.area_lights[0] = all[l];
        float *shadowed = fixture_light(&f, &shadows_pipeline, &statistics);
        assert_true(statistics.visibility_rays > PIXELS);
        empty.triangle_count = 0; /* nothing to throw shadows */
        f.frame.scene = &empty;
        empty.area_light_count = 1;
        float *open = fixture_light(&f, &shadows_pipeline, &statistics);
        f.frame.scene = &f.scene;
        int same = 0, half = 0, surfaces = 0;
        for (size_t i = 0; i < PIXELS; i++) {
            if (f.position[4 * i + 3] <= 0)
                continue;
            double expected = share(&f, &embree, &all[l], i) * (double)open[4 * i];
            surfaces++;
            same += fabs((double)shadowed[4 * i] - expected) <= 1e-3 * (double)open[4 * i] + 1e-6;
            half += expected > 0.05 * (double)open[4 * i] && expected < 0.95 * (double)open[4 * i];
        }
        printf("light %zu: %d of %d pixels as Embree has them, %d in half shadow\n", l, same,
               surfaces, half);
        assert_true(half > 100);
        assert_true(same >= surfaces - surfaces / 200); /* rays along edges */
        free(shadowed);
        free(open);
    }
    f.scene.area_lights[0] = all[0];
    f.scene.area_light_count = lights;
    embree_close(&embree);
    fixture_close(&f);
}

/* Pixels where ceiling and walls meet: some lie behind the wall by the rounding of their position.
 */
static void edges_are_lit(void **state)
{
    (void)state;
    fixture f;
    fixture_open(&f, "box_area", 128, 96);
    render_statistics statistics;
    float *light = fixture_light(&f, &shadows_pipeline, &statistics);
    int edges = 0, dark = 0;
    for (size_t i = 0; i < (size_t)128 * 96; i++) {
        if (f.position[4 * i + 3] <= 0 || f.normal[i][1] > -0.9F ||
            fabs(fabs((double)f.position[4 * i]) - 1) > 1e-5)
            continue;
        edges++;
        dark += light[4 * i] <= 0;
    }
    printf("%d of %d pixels are dark\n", dark, edges);
    assert_true(edges > 4);
    assert_int_equal(dark, 0);
    free(light);
    fixture_close(&f);
}

/* ---- Pipelines ----------------------------------------------------------------------- */

static const render_pipeline *const rivals[] = {
    &multires_pipeline,      &multires_same_pipeline, &multires_apart_pipeline, &nichols_pipeline,
    &multires_lobe_pipeline, &shadows2_pipeline,      &shadows4_pipeline};

enum { RIVALS = sizeof rivals / sizeof *rivals };

static uint64_t fragments_of(const render_statistics *statistics)
{
    uint64_t sum = 0;
    for (int i = 0; i < RENDER_LEVELS; i++)
        sum += statistics->fragments_by_level[i];
    return sum;
}

static void pipelines_come_near_ground_truth(void **state)
{
    (void)state;
    static const double most[RIVALS] = {0.05, 0.06, 0.06, 0.12, 0.08, 0.05, 0.10};
    fixture f;
    fixture_open(&f, "box_area", 256, 192);
    render_statistics truth_statistics, statistics[RIVALS];
    size_t pixels = 256 * 192;
    float *truth = fixture_light(&f, &shadows_pipeline, &truth_statistics);
    render_comparison comparisons[RIVALS];
    for (int i = 0; i < RIVALS; i++) {
        float *light = fixture_light(&f, rivals[i], &statistics[i]);
        render_compare(pixels, light, truth, NULL, &comparisons[i]);
        printf("%s: rel %.4f, p99 %.4f, %llu fragments, %llu rays of %llu\n", rivals[i]->id,
               comparisons[i].rel, comparisons[i].p99,
               (unsigned long long)fragments_of(&statistics[i]),
               (unsigned long long)statistics[i].visibility_rays,
               (unsigned long long)truth_statistics.visibility_rays);
        assert_int_equal(statistics[i].pixels_uncovered, 0);
        assert_int_equal(statistics[i].pixels_covered, truth_statistics.pixels_covered);
        assert_true(comparisons[i].rel < most[i]);
        float *again = i % 3 ? NULL : fixture_light(&f, rivals[i], &statistics[i]);
        if (again) /* multires and nichols: the same pixels whatever the order of the lists */
            assert_memory_equal(light, again, pixels * 16);
        free(light);
        free(again);
    }
    /* what it is for: fewer fragments and rays than Nichols', and less error */
    assert_true(comparisons[0].rel < comparisons[3].rel);
    assert_true(fragments_of(&statistics[0]) < fragments_of(&statistics[3]));
    assert_true(3 * statistics[0].visibility_rays < statistics[3].visibility_rays);
    free(truth);
    fixture_close(&f);
}

static void what_cannot_be_done_is_said(void **state)
{
    (void)state;
    fixture f;
    fixture_open(&f, "box", 32, 24);
    void *pipeline_state;
    for (int i = -1; i < RIVALS; i++) {
        const render_pipeline *pipeline = i < 0 ? &shadows_pipeline : rivals[i];
        refused(pipeline->create(&f.frame, &pipeline_state), GPU_UNSUPPORTED, "\"box\" has none");
        assert_null(pipeline_state);
    }
    fixture_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_stratified),
        cmocka_unit_test(points_cover_any_polygon_evenly),
        cmocka_unit_test(ground_truth_is_what_embree_sees),
        cmocka_unit_test(edges_are_lit),
        cmocka_unit_test(pipelines_come_near_ground_truth),
        cmocka_unit_test(what_cannot_be_done_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
