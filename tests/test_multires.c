/* Discontinuity pyramids and light culling of the multiresolution pipelines, against the same done
 * on the host. */
#include "multires_fixture.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pyramids_hold_the_discontinuities),
        cmocka_unit_test(first_fragments_are_the_coarsest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
