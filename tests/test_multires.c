/* Discontinuity pyramids, light culling and refinement of the multiresolution pipelines, against
 * the same done on the host. */
#include "multires_fixture.h"

#include "embree.h"

enum { WIDTH = 152, HEIGHT = 98 };

static const float mixed = 1e9F;

/* ---- Pyramids and the first fragments (3.1.1) ------------------------------------------ */

static double off_planes(const fixture *f, size_t a, size_t b)
{
    const float *p = f->position + 4 * a, *q = f->position + 4 * b;
    float d[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    const view_data *view = gpu_buffer_map(f->frame.view);
    double size = (double)view->eye[3] * fmin((double)p[3], (double)q[3]);
    return fmax(fabs(dot(d, f->face[a])), fabs(dot(d, f->face[b]))) / size;
}

/* The definition in pyramids.comp, over all pairs of neighbours in the fragment. */
static double expect_discontinuity(const fixture *f, int level, uint32_t x, uint32_t y)
{
    uint32_t width = 1u << level, there = 0;
    double low[3] = {2, 2, 2}, high[3] = {-2, -2, -2}, off = 0, range = 0;
    for (uint32_t j = y * width; j < (y + 1) * width; j++)
        for (uint32_t i = x * width; i < (x + 1) * width; i++) {
            if (i >= f->frame.width || j >= f->frame.height)
                continue;
            size_t at = (size_t)j * f->frame.width + i;
            there += f->position[4 * at + 3] > 0;
            for (int k = 0; k < 3; k++) {
                low[k] = fmin(low[k], (double)f->normal[at][k]);
                high[k] = fmax(high[k], (double)f->normal[at][k]);
            }
        }
    if (there < width * width)
        return there ? (double)mixed : -1;
    for (uint32_t j = y * width; j < (y + 1) * width; j++)
        for (uint32_t i = x * width; i < (x + 1) * width; i++) {
            size_t at = (size_t)j * f->frame.width + i;
            if (i + 1 < (x + 1) * width)
                off = fmax(off, off_planes(f, at, at + 1));
            if (j + 1 < (y + 1) * width)
                off = fmax(off, off_planes(f, at, at + f->frame.width));
        }
    for (int k = 0; k < 3; k++)
        range += (high[k] - low[k]) * (high[k] - low[k]);
    return fmax(off / (double)multires_default.plane_limit,
                sqrt(range) / (double)multires_default.normal_limit);
}

static void pyramids_hold_the_discontinuities(void **state)
{
    (void)state;
    fixture f;
    fixture_open(&f, "box_area", WIDTH, HEIGHT);
    multires m;
    run_first(&f, &m);
    int above = 0, below = 0;
    for (int l = 1; l < RENDER_LEVELS; l++)
        for (uint32_t y = 0; y < m.push[0].tiles[1] << (4 - l); y++)
            for (uint32_t x = 0; x < m.push[0].tiles[0] << (4 - l); x++) {
                double expected = expect_discontinuity(&f, l, x, y);
                double found = (double)discontinuity(&m, l, x, y);
                if (fabs(found - expected) > 1e-3 * fmax(1, fabs(expected)))
                    fail_msg("level %d, fragment %u, %u: %g, expected %g", l, x, y, found,
                             expected);
                above += expected > 1;
                below += expected >= 0 && expected <= 1;
            }
    assert_true(above > 100 && below > 100);
    multires_destroy(&m);
    fixture_close(&f);
}

/* Each pixel with a surface is in exactly one first fragment, the coarsest that is continuous. */
static void first_fragments_are_the_coarsest(void **state)
{
    (void)state;
    fixture f;
    fixture_open(&f, "box_area", WIDTH, HEIGHT);
    multires m;
    run_first(&f, &m);
    unsigned char *covered = calloc(WIDTH * HEIGHT, 1);
    for (int l = 1; l < RENDER_LEVELS; l++) {
        uint32_t count = list_count(&m, l);
        for (uint32_t i = 0; i < count; i++) {
            uint32_t entry = list_entries(&m, l)[i], x = entry & 0x3fff, y = entry >> 14 & 0x3fff;
            float value = discontinuity(&m, l, x, y);
            assert_true(value <= 1 || (l == 1 && entry >> 31));
            assert_true(l == 4 || discontinuity(&m, l + 1, x / 2, y / 2) > 1);
            for (uint32_t j = y << l; j < (y + 1) << l && j < HEIGHT; j++)
                for (uint32_t k = x << l; k < (x + 1) << l && k < WIDTH; k++)
                    covered[j * WIDTH + k]++;
        }
        for (uint32_t y = 0; y < m.push[0].tiles[1] << (4 - l); y++)
            for (uint32_t x = 0; x < m.push[0].tiles[0] << (4 - l); x++)
                if (state_of(&m, l, x, y) == STATE_DARK)
                    for (uint32_t j = y << l; j < (y + 1) << l; j++)
                        for (uint32_t k = x << l; k < (x + 1) << l; k++)
                            covered[j * WIDTH + k]++;
    }
    for (size_t i = 0; i < WIDTH * HEIGHT; i++)
        assert_true(f.position[4 * i + 3] > 0 ? covered[i] == 1 : covered[i] <= 1);
    free(covered);
    multires_destroy(&m);
    fixture_close(&f);
}

/* ---- Visibility and refinement (3.1.2, 3.1.3) ------------------------------------------ */

/* Bits of a set of 16 points of a light, traced by Embree. */
static uint32_t see(const fixture *f, const embree_scene *embree, const render_area_light *light,
                    uint32_t x, uint32_t y, int set)
{
    size_t at = (size_t)y * f->frame.width + x;
    const float *p = f->position + 4 * at;
    double size = (double)p[3], n[3];
    for (int k = 0; k < 3; k++)
        size = fmax(size, fabs((double)p[k]));
    float points[SHADOWS_POINTS][4], origin[3], reach;
    double extent = 0;
    for (int i = 0; i < light->corner_count; i++)
        for (int k = 0; k < 3; k++)
            extent = fmax(extent, fabs(light->corners[i][k]));
    shadows_points(light, 1e-4 * extent, points);
    shadows_normal(light, n);
    for (int k = 0; k < 3; k++)
        origin[k] = p[k] + (float)(1e-4 * size) * f->face[at][k];
    uint32_t bits = 0;
    for (int i = 0; i < 16; i++) {
        const float *to = points[16 * set + i];
        float d[3], from[3];
        double facing = 0;
        for (int k = 0; k < 3; k++) {
            d[k] = to[k] - origin[k];
            from[k] = to[k] - p[k];
            facing -= (double)from[k] * n[k];
        }
        bool counts = facing > 0 && dot(from, f->normal[at]) > 0 && dot(from, f->face[at]) > 0;
        if (counts && embree_closest(embree, origin, d, 1, &reach) == UINT32_MAX)
            bits |= 1u << i;
    }
    return bits;
}

/* What becomes of a fragment of level 4: children, in the order of their entries with the level
 * above bit 28. */
static int expect_children(const fixture *f, const embree_scene *embree, uint32_t entry,
                           uint32_t children[16])
{
    static const uint32_t round[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    uint32_t x = entry & 0x3fff, y = entry >> 14 & 0x3fff, differ = 0, twice = 0;
    uint32_t corners = 0;
    for (size_t l = 0; l < f->scene.area_light_count; l++) {
        uint32_t bits[4], all = 0xffff, any = 0;
        for (int i = 0; i < 4; i++) {
            bits[i] = see(f, embree, &f->scene.area_lights[l], 16 * x + 8 * round[i][0] + 4,
                          16 * y + 8 * round[i][1] + 4, 0);
            all &= bits[i];
            any |= bits[i];
        }
        differ |= any & ~all;
        for (int i = 0; i < 4 && !any; i++) /* dark: from its corners */
            corners |= see(f, embree, &f->scene.area_lights[l], 16 * x + 15 * round[i][0],
                           16 * y + 15 * round[i][1], i);
        for (int i = 0; i < 4; i++)
            if (abs(__builtin_popcount(bits[i]) - __builtin_popcount(bits[(i + 1) % 4])) > 4)
                twice |= 1u << i | 1u << ((i + 1) % 4);
    }
    int count = 0;
    if (!differ && corners)
        differ = 1, twice = 0;
    for (uint32_t i = 0; differ && i < 4; i++) {
        uint32_t sx = 2 * x + round[i][0], sy = 2 * y + round[i][1];
        if (!(twice >> i & 1))
            children[count++] = sx | sy << 14 | 3u << 28;
        for (uint32_t k = 0; (twice >> i & 1) && k < 4; k++)
            children[count++] = (2 * sx + round[k][0]) | (2 * sy + round[k][1]) << 14 | 2u << 28;
    }
    return count;
}

static bool in_list(const multires *m, uint32_t child)
{
    uint32_t level = child >> 28, entry = child & 0xfffffff;
    for (uint32_t i = 0; i < list_count(m, (int)level); i++)
        if ((list_entries(m, (int)level)[i] & 0xfffffff) == entry)
            return true;
    return false;
}

static void fragments_split_where_visibility_differs(void **state)
{
    (void)state;
    fixture f;
    fixture_open(&f, "box_area", WIDTH * 2, HEIGHT * 2);
    embree_scene embree = embree_open(&f.scene);
    multires m;
    run_first(&f, &m);
    uint32_t before[2] = {list_count(&m, 3), list_count(&m, 2)}, count = list_count(&m, 4);
    uint32_t *tops = sorted_list(&m, 4);
    gpu_buffer *between;
    gpu_compute *test = compile_test(&f, &between);
    gpu_step step = multires_list_step(&f.frame, &m, "test", test, 4, 4, between);
    must(gpu_run(f.device, &step, 1, NULL));
    int same = 0, kept = 0, once = 0, again = 0;
    uint32_t expected[2] = {0, 0};
    for (uint32_t i = 0; i < count; i++) {
        uint32_t children[16], x = tops[i] & 0x3fff, y = tops[i] >> 14 & 0x3fff;
        int number = expect_children(&f, &embree, tops[i], children), found = 0;
        for (int k = 0; k < number; k++) {
            found += in_list(&m, children[k]);
            expected[children[k] >> 28 == 2]++;
        }
        bool is_final = state_of(&m, 4, x, y) == STATE_FINAL;
        same += number ? found == number && !is_final : is_final;
        kept += number == 0, once += number == 4, again += number > 4;
    }
    printf("%u fragments of 16 pixels: %d final, %d split, %d split twice; %d as on the host\n",
           count, kept, once, again, same);
    assert_true(kept > 5 && once > 5 && again > 2);
    assert_true(same >= (int)count - (int)count / 50); /* a ray along an edge */
    for (int i = 0; i < 2; i++) {
        double made = list_count(&m, 3 - i) - before[i];
        assert_true(fabs(made - expected[i]) <= 0.02 * expected[i] + 4);
    }
    free(tops);
    gpu_compute_destroy(test);
    gpu_buffer_destroy(between);
    multires_destroy(&m);
    embree_close(&embree);
    fixture_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pyramids_hold_the_discontinuities),
        cmocka_unit_test(first_fragments_are_the_coarsest),
        cmocka_unit_test(fragments_split_where_visibility_differs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
