/* Poisson-disk samples on surfaces, what they deposit where, and the geometry volume. */
#include "render_fixture.h"

#include "render/lpv.h"

static double distance(const float a[3], const float b[3])
{
    double square = 0;
    for (int k = 0; k < 3; k++)
        square += ((double)a[k] - (double)b[k]) * ((double)a[k] - (double)b[k]);
    return sqrt(square);
}

/* Every pair, and every dart with its sample. */
static void check_discs(const lpv_samples *s)
{
    for (size_t i = 0; i < s->count; i++)
        for (size_t j = 0; j < i; j++)
            if (distance(s->samples[i].position, s->samples[j].position) < s->radius * (1 - 1e-6))
                fail_msg("samples %zu and %zu are %g apart, radius %g", i, j,
                         distance(s->samples[i].position, s->samples[j].position), s->radius);
    for (size_t i = 0; i < s->dart_count; i++)
        assert_true(distance(s->darts[i].position, s->samples[s->darts[i].sample].position) <
                    s->radius * (1 + 1e-6));
}

static double area_of(const lpv_samples *s)
{
    double sum = 0;
    for (size_t i = 0; i < s->count; i++)
        sum += (double)s->samples[i].position[3];
    return sum;
}

static void samples_keep_their_distance(void **state)
{
    (void)state;
    fixture f;
    fixture_make(&f);
    size_t counts[3];
    for (size_t i = 0; i < 3; i++) {
        lpv_samples s;
        lpv_samples_make(&f.scene, (size_t)100 << (2 * i), 20000, &s);
        check_discs(&s);
        double area = 16 + 12 + 12, corners[3][3], side[2][3], across[3];
        for (int c = 0; c < 3; c++)
            fixture_corner(&f, 6, c, corners[c]);
        for (int k = 0; k < 3; k++)
            side[0][k] = corners[1][k] - corners[0][k], side[1][k] = corners[2][k] - corners[0][k];
        fixture_cross(side[0], side[1], across);
        area += 0.5 * sqrt(fixture_dot(across, across));
        assert_near(area_of(&s), area, 1e-3 * area);
        counts[i] = s.count;
        lpv_samples_free(&s);
        assert_in_range(counts[i], (100 << (2 * i)) / 2, (100 << (2 * i)) * 2);
    }
}

static void samples_are_on_their_triangles(void **state)
{
    (void)state;
    fixture f;
    fixture_make(&f);
    lpv_samples s;
    lpv_samples_make(&f.scene, 300, 5000, &s);
    int of_material[3] = {0, 0, 0};
    for (size_t i = 0; i < s.count; i++) {
        const lpv_sample *p = &s.samples[i];
        bool found = false;
        for (size_t t = 0; t < f.scene.triangle_count && !found; t++) {
            double n[3], c[3], height = 0, along = 0;
            fixture_face(&f, t, n);
            fixture_corner(&f, t, 0, c);
            for (int k = 0; k < 3; k++) {
                height += ((double)p->position[k] - c[k]) * n[k];
                along += (double)p->face[k] * n[k];
            }
            const float *albedo = f.albedos + 3 * f.materials[t];
            found = fabs(height) < 1e-5 && along > 1 - 1e-5 && p->albedo[0] == albedo[0] &&
                    p->albedo[1] == albedo[1] && p->albedo[2] == albedo[2];
            of_material[f.materials[t]] += found;
        }
        assert_true(found);
        assert_near(distance(p->normal, p->face), 0, 1e-6);
    }
    assert_true(of_material[0] > 50 && of_material[1] > 30 && of_material[2] > 30);
    lpv_samples_free(&s);
}

/* Many triangles that lie apart: one sample each would be too many. */
static void scattered_surfaces_do_not_fill_memory(void **state)
{
    (void)state;
    fixture f;
    memset(&f, 0, sizeof f);
    fixture_make(&f);
    f.scene.triangle_count = f.scene.vertex_count = 0;
    for (int i = 0; i < 60; i++) {
        float x = 10.0F * (float)(i % 8), z = 10.0F * (float)(i / 8);
        fixture_add(&f, (float[]){x, 0, z, x + 0.1F, 0, z, x, 0, z + 0.1F}, 0);
    }
    lpv_samples s;
    lpv_samples_make(&f.scene, 20, 4000, &s);
    assert_in_range(s.count, 1, 40);
    check_discs(&s);
    assert_near(area_of(&s), 60 * 0.005, 1e-4);
    lpv_samples_free(&s);
}

static void nothing_gives_no_samples(void **state)
{
    (void)state;
    fixture f;
    fixture_make(&f);
    f.scene.triangle_count = 0;
    lpv_samples s;
    lpv_samples_make(&f.scene, 100, 1000, &s);
    assert_int_equal(s.count, 0);
    assert_int_equal(s.dart_count, 0);
    lpv_samples_free(&s);
}

/* ---- The volume ----------------------------------------------------------------------- */

static double deposited(const lpv_volume *v)
{
    double sum = 0;
    for (size_t i = 0; i < v->entry_count; i++)
        sum += (double)v->entries[i].area;
    return sum;
}

/* A wall across the middle of a cube whose corners two small triangles mark. */
static void make_wall(fixture *f)
{
    fixture_make(f);
    f->scene.triangle_count = f->scene.vertex_count = 0;
    fixture_quad(f, (float[]){0, 0, 2, 0, 4, 2, 4, 4, 2, 4, 0, 2}, 0);
    for (int k = 0; k < 3; k++) {
        f->scene.low[k] = 0;
        f->scene.high[k] = 4;
    }
}

static void a_wall_blocks_what_crosses_it(void **state)
{
    (void)state;
    fixture f;
    make_wall(&f);
    lpv_samples s;
    lpv_volume v;
    lpv_samples_make(&f.scene, 200, 40000, &s);
    lpv_volume_make(&f.scene, &s, 8, &v);
    assert_int_equal(v.voxels, 512);
    for (uint32_t z = 0; z < 8; z++)
        for (uint32_t i = 0; i < 64; i++) {
            const float *open = v.open + 4 * (i + 64 * z);
            assert_true(open[0] == 1 && open[1] == 1); /* the light that goes along it */
            assert_true(z == 3 ? open[2] < 0.2F : open[2] == 1);
            /* the two sides are in the layers before and behind it */
            assert_true((v.first[i + 64 * z + 1] > v.first[i + 64 * z]) == (z == 3 || z == 4));
        }
    for (size_t voxel = 0; voxel < v.voxels; voxel++)
        for (uint32_t e = v.first[voxel]; e < v.first[voxel + 1]; e++) {
            const lpv_sample *sample = &s.samples[v.entries[e].side / 2];
            bool up = (sample->face[2] > 0) == (v.entries[e].side % 2 == 0);
            assert_true(up == (voxel / 64 == 4));
        }
    assert_near(deposited(&v), 2 * 16, 1e-3); /* both sides */
    lpv_volume_free(&v);
    lpv_samples_free(&s);
}

static void half_a_wall_blocks_half(void **state)
{
    (void)state;
    fixture f;
    make_wall(&f);
    for (size_t i = 0; i < 18; i++)
        if (i % 3 == 1)
            f.positions[i] /= 2;
    lpv_samples s;
    lpv_volume v;
    lpv_samples_make(&f.scene, 200, 40000, &s);
    lpv_volume_make(&f.scene, &s, 4, &v);
    for (uint32_t i = 0; i < 16; i++)
        assert_near((double)v.open[4 * (i + 16) + 2], i / 4 < 2 ? 0 : 1, 0.15);
    lpv_volume_free(&v);
    lpv_volume_make(&f.scene, &s, 2, &v);
    assert_near((double)v.open[2], 0, 0.1);
    assert_near((double)v.open[4 * 2 + 2], 1, 0.05);
    lpv_volume_free(&v);
    /* a quarter of a wall, in the part of a voxel: half of its face, and the cube of that */
    lpv_volume_make(&f.scene, &s, 3, &v);
    assert_near((double)v.open[4 * (3 + 9) + 2], 1 - 0.125, 0.05);
    lpv_volume_free(&v);
    /* a single voxel: all of one side is in it, the other a little outside; nothing lies between
     * two centres */
    lpv_volume_make(&f.scene, &s, 1, &v);
    assert_int_equal(v.voxels, 1);
    assert_true(v.open[0] == 1 && v.open[1] == 1);
    assert_near(deposited(&v), 8, 1e-3);
    lpv_volume_free(&v);
    lpv_samples_free(&s);
}

/* Voxels are cubes and no side has more of them than asked for; flat scenes have two. */
static void odd_shapes_fit(void **state)
{
    (void)state;
    static const double high[][3] = {{7, 3, 1}, {1, 9, 9}, {5, 0, 5}, {0.01, 4, 0}, {3, 3, 3}};
    for (size_t i = 0; i < sizeof high / sizeof *high; i++)
        for (uint32_t n = 1; n <= 7; n += 2) {
            fixture f;
            make_wall(&f);
            memcpy(f.scene.high, high[i], sizeof high[i]);
            lpv_samples s;
            lpv_volume v;
            lpv_samples_make(&f.scene, 10, 100, &s);
            lpv_volume_make(&f.scene, &s, n, &v);
            double longest = fmax(high[i][0], fmax(high[i][1], high[i][2]));
            assert_near(v.side, longest / n, 1e-9);
            assert_int_equal(v.voxels, (size_t)v.size[0] * v.size[1] * v.size[2]);
            for (int k = 0; k < 3; k++) {
                assert_in_range(v.size[k], 1, n);
                double reach = v.low[k] + v.side * v.size[k];
                assert_true(v.low[k] <= 1e-9 && reach >= high[i][k] - 1e-3 * v.side);
            }
            lpv_volume_free(&v);
            lpv_samples_free(&s);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_keep_their_distance),
        cmocka_unit_test(samples_are_on_their_triangles),
        cmocka_unit_test(scattered_surfaces_do_not_fill_memory),
        cmocka_unit_test(nothing_gives_no_samples),
        cmocka_unit_test(a_wall_blocks_what_crosses_it),
        cmocka_unit_test(half_a_wall_blocks_half),
        cmocka_unit_test(odd_shapes_fit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
