/* Refinement of the multiresolution pipeline, against the same done on the host: the mean
 * irradiance that bits are weighed by, fragments that split, pixels that look at lights alone. */
#include "multires_fixture.h"

#include "embree.h"
#include "workspace.h"

enum { WIDTH = 152, HEIGHT = 98 };

/* ---- Visibility and refinement (3.1.2, 3.1.3) ------------------------------------------ */

/* Bits of a set of 16 points of a light, traced by Embree. */
static uint32_t see(const fixture *f, const embree_scene *embree, const render_area_light *light,
                    uint32_t x, uint32_t y, int set)
{
    size_t at = (size_t)y * f->frame.width + x;
    const float *p = f->position + 4 * at;
    float points[SHADOWS_POINTS][4], origin[3];
    double n[3];
    shadow_rays(f, light, at, points, n, origin);
    uint32_t bits = 0;
    for (int i = 0; i < 16; i++) {
        const float *to = points[16 * set + i];
        float from[3];
        double facing = 0;
        for (int k = 0; k < 3; k++) {
            from[k] = to[k] - p[k];
            facing -= (double)from[k] * n[k];
        }
        bool counts = facing > 0 && dot(from, f->normal[at]) > 0 && dot(from, f->face[at]) > 0;
        if (counts && embree_is_open(embree, origin, to))
            bits |= 1u << i;
    }
    return bits;
}

static const uint32_t round_the[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

typedef struct looked {
    uint32_t any[4], all[4], corners[4]; /* of the four sets of points */
    double worth;
    bool dark; /* nothing of it was seen in the first round */
} looked;

static int ones(uint32_t bits)
{
    return __builtin_popcount(bits);
}

/* What may differ, of what may where the irradiance is the image's mean. */
static double allowance(double local)
{
    return fmin((0.02 + local) / 1.02, 1);
}

/* A light in the second round, see sub.glsl: what differs. */
static double differs_again(const looked *l, double tolerance)
{
    int differ = 0, more = 0;
    bool lit = false, bright = l->worth > 0.3;
    for (int i = 0; i < 4; i++) {
        differ += ones((l->any[i] | l->corners[i]) & ~(l->all[i] & l->corners[i]));
        more += ones(l->corners[i]) - ones(l->any[i]);
        lit = lit || l->corners[i];
    }
    if (l->dark)
        return lit ? 1e9 : 0;
    return bright ? differ * l->worth / 32 : abs(more) * l->worth > 64 * tolerance ? 1e9 : 0;
}

/* From one of the four, over the image's mean irradiance. */
static double worth_at(const fixture *f, double mean, const render_area_light *light, uint32_t x,
                       uint32_t y, int i)
{
    return exitance(light) / mean *
           form_factor(f, light, 16 * x + 8 * round_the[i][0] + 4,
                       16 * y + 8 * round_the[i][1] + 4);
}

/* What a fragment of level 4 sees of a light. */
static looked look(const fixture *f, const embree_scene *embree, double mean,
                   const render_area_light *light, uint32_t x, uint32_t y, uint32_t first[4])
{
    looked l = {.worth = 0};
    for (int i = 0; i < 4; i++)
        l.worth = fmax(l.worth, worth_at(f, mean, light, x, y, i));
    for (int set = 0; set < 4; set++) {
        l.all[set] = 0xffff;
        for (int i = 0; i < 4; i++) {
            uint32_t bits = see(f, embree, light, 16 * x + 8 * round_the[i][0] + 4,
                                16 * y + 8 * round_the[i][1] + 4, set);
            first[i] = set == 0 ? bits : first[i];
            if (l.worth > 0.3 || i == set) /* not bright: a set each */
                l.any[set] |= bits, l.all[set] &= bits;
        }
        l.corners[set] = see(f, embree, light, 16 * x + 15 * round_the[set][0],
                             16 * y + 15 * round_the[set][1], set);
    }
    return l;
}

/* What becomes of a fragment of level 4: children, in the order of their entries with the level
 * above bit 28. */
static int expect_children(const fixture *f, const embree_scene *embree, double mean,
                           uint32_t entry, uint32_t children[16])
{
    uint32_t x = entry & 0x3fff, y = entry >> 14 & 0x3fff, twice = 0;
    double differ = 0, again = 0, local = 0, tolerance = (double)multires_default.tolerance / 3;
    looked found[8];
    for (size_t l = 0; l < f->scene.area_light_count; l++) {
        uint32_t bits[4], all = 0xffff, any = 0;
        const render_area_light *light = &f->scene.area_lights[l];
        found[l] = look(f, embree, mean, light, x, y, bits);
        for (int i = 0; i < 4; i++) {
            int gradient = abs(ones(bits[i]) - ones(bits[(i + 1) % 4]));
            all &= bits[i];
            any |= bits[i];
            if (gradient > 4 && gradient * found[l].worth > 16 * tolerance)
                twice |= 1u << i | 1u << ((i + 1) % 4);
            local += ones(bits[i]) * worth_at(f, mean, light, x, y, i) / 64;
        }
        differ += ones(any & ~all) * found[l].worth / 16;
        found[l].dark = !any;
    }
    tolerance *= allowance(local);
    for (size_t l = 0; l < f->scene.area_light_count; l++)
        again += differs_again(&found[l], tolerance);
    int count = 0;
    for (uint32_t i = 0; differ + again > tolerance && i < 4; i++) {
        uint32_t sx = 2 * x + round_the[i][0], sy = 2 * y + round_the[i][1];
        if (!(twice >> i & 1))
            children[count++] = sx | sy << 14 | 3u << 28;
        for (uint32_t k = 0; (twice >> i & 1) && k < 4; k++)
            children[count++] =
                (2 * sx + round_the[k][0]) | (2 * sy + round_the[k][1]) << 14 | 2u << 28;
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

/* Of the pixels in the middle of the tiles, by the set of 16 points that is the tile's turn. */
static void the_mean_is_that_of_a_pixel_a_tile(void **state)
{
    (void)state;
    fixture f;
    fixture_open(&f, "box_area", WIDTH * 2, HEIGHT * 2);
    embree_scene embree = embree_open(&f.scene);
    multires m;
    run_first(&f, &m);
    double sum = 0;
    int count = 0;
    for (uint32_t tile = 0; tile < m.tiles; tile++) {
        uint32_t across = m.push[0].tiles[0];
        uint32_t x = 16 * (tile % across) + 8, y = 16 * (tile / across) + 8;
        if (x >= f.frame.width || y >= f.frame.height ||
            f.position[4 * ((size_t)y * f.frame.width + x) + 3] <= 0)
            continue;
        count++;
        for (size_t l = 0; l < f.scene.area_light_count; l++) {
            const render_area_light *light = &f.scene.area_lights[l];
            sum += exitance(light) * form_factor(&f, light, x, y) / 16 *
                   ones(see(&f, &embree, light, x, y, tile % 4));
        }
    }
    printf("mean irradiance %g, on the host %g\n", mean_of(&m), sum / count);
    /* points count alike on the host, and by their weights on the device */
    assert_true(count > 100 && fabs(mean_of(&m) - sum / count) < 0.03 * sum / count);
    multires_destroy(&m);
    embree_close(&embree);
    fixture_close(&f);
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
    double mean = mean_of(&m);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t children[16], x = tops[i] & 0x3fff, y = tops[i] >> 14 & 0x3fff;
        int number = expect_children(&f, &embree, mean, tops[i], children), found = 0;
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

/* A plane with a light close above it, between the samples of a fragment. */
static void open_spot(fixture *f)
{
    char folder[1000];
    const char *root = getenv("SGFIT_ROOT");
    snprintf(folder, sizeof folder, "%s/tests/scenes", root ? root : ".");
    workspace at;
    workspace_open(&at);
    workspace_write(&at, "spot.json",
                    "{\"meshes\": [{\"file\": \"plane.obj\"}],"
                    " \"camera\": {\"eye\": [0, 1.2, 0.6], \"target\": [0, 0, 0]},"
                    " \"area_lights\": [{\"exitance\": 9, \"vertices\": ["
                    "[0, 0.02, 0], [0.02, 0.02, 0], [0.02, 0.02, 0.02], [0, 0.02, 0.02]]}]}");
    *f = (fixture){.device = open_software_device()};
    assert_true(render_scene_read(at.path, folder, &f->scene));
    workspace_close(&at);
    fixture_frame(f, WIDTH, HEIGHT);
}

static void a_spot_between_samples_splits(void **state)
{
    (void)state;
    fixture f;
    open_spot(&f);
    multires m;
    run_first(&f, &m);
    gpu_buffer *between;
    gpu_compute *test = compile_test(&f, &between);
    gpu_step step = multires_list_step(&f.frame, &m, "test", test, 4, 4, between);
    must(gpu_run(f.device, &step, 1, NULL));
    int kept = 0;
    double most = 0, worst = 0, worth = exitance(f.scene.area_lights) / mean_of(&m);
    for (uint32_t y = 0; y < HEIGHT; y++)
        for (uint32_t x = 0; x < WIDTH; x++) {
            bool is_final = state_of(&m, 4, x / 16, y / 16) == STATE_FINAL;
            double light = worth * form_factor(&f, f.scene.area_lights, x, y);
            most = fmax(most, light);
            worst = is_final ? fmax(worst, light) : worst;
            kept += is_final;
        }
    printf("spot of %g times the mean irradiance; in %d pixels of final fragments up to %g\n", most,
           kept, worst);
    assert_true(most > 5 && kept > 0 && worst < 5);
    gpu_compute_destroy(test);
    gpu_buffer_destroy(between);
    multires_destroy(&m);
    fixture_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_mean_is_that_of_a_pixel_a_tile),
        cmocka_unit_test(fragments_split_where_visibility_differs),
        cmocka_unit_test(a_spot_between_samples_splits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
