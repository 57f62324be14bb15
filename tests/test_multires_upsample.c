/* Additional samples and single-pass upsampling of the multiresolution pipeline. */
#include "multires_fixture.h"

enum { WIDTH = 152, HEIGHT = 98 };

/* ---- Additional samples and upsampling (3.1.4, 3.1.5) ---------------------------------- */

typedef struct full_run {
    multires m;
    gpu_compute *test, *quads, *additional, *upsample;
    gpu_buffer *kept;
    float *light;
} full_run;

static full_run run_all(fixture *f)
{
    static const gpu_binding image = GPU_STORAGE_IMAGE;
    full_run r;
    run_first(f, &r.m);
    r.test = compile_test(f, &r.kept);
    r.quads = compile_quads(f);
    must(multires_compute(&f->frame, "multires/additional.comp", NULL, &r.additional));
    must(multires_compute(&f->frame, "multires/upsample.comp", &image, &r.upsample));
    gpu_step steps[6];
    for (int l = 4; l > 0; l--)
        steps[4 - l] =
            multires_list_step(&f->frame, &r.m, "test", l > 1 ? r.test : r.quads, l, l, r.kept);
    steps[4] = multires_list_step(&f->frame, &r.m, "additional", r.additional, 0, 0, NULL);
    steps[5] = multires_step(&f->frame, &r.m, "upsample", r.upsample, 0, f->frame.light);
    steps[5].groups[0] = (f->frame.width + 15) / 16;
    steps[5].groups[1] = (f->frame.height + 7) / 8;
    must(gpu_run(f->device, steps, 6, NULL));
    r.light = malloc((size_t)f->frame.width * f->frame.height * 16);
    must(gpu_image_read(f->frame.light, r.light));
    return r;
}

static void close_run(full_run *r)
{
    gpu_compute_destroy(r->test);
    gpu_compute_destroy(r->quads);
    gpu_compute_destroy(r->additional);
    gpu_compute_destroy(r->upsample);
    gpu_buffer_destroy(r->kept);
    multires_destroy(&r->m);
    free(r->light);
}

static void large_fragments_have_three_more_samples(void **state)
{
    (void)state;
    fixture f;
    fixture_open(&f, "box_area", WIDTH, HEIGHT);
    full_run r = run_all(&f);
    uint32_t large = 0, samples = 0;
    for (int l = 3; l < RENDER_LEVELS; l++)
        for (uint32_t y = 0; y < r.m.push[0].tiles[1] << (4 - l); y++)
            for (uint32_t x = 0; x < r.m.push[0].tiles[0] << (4 - l); x++) {
                if (state_of(&r.m, l, x, y) != STATE_FINAL)
                    continue;
                uint32_t left = x << l, top = y << l, half = 1u << (l - 1);
                assert_int_equal(state_of(&r.m, 0, left, top), STATE_SAMPLE);
                assert_int_equal(state_of(&r.m, 0, left + half, top), STATE_SAMPLE);
                assert_int_equal(state_of(&r.m, 0, left, top + half), STATE_SAMPLE);
                large++;
            }
    for (uint32_t y = 0; y < r.m.push[0].tiles[1] * 16; y++)
        for (uint32_t x = 0; x < r.m.push[0].tiles[0] * 16; x++)
            samples += state_of(&r.m, 0, x, y) == STATE_SAMPLE;
    assert_true(large > 10);
    assert_int_equal(samples, 3 * large);
    close_run(&r);
    fixture_close(&f);
}

typedef struct bounds {
    float low[3], high[3];
} bounds;

static void widen(bounds *b, const float *value)
{
    for (int k = 0; k < 3; k++) {
        b->low[k] = fminf(b->low[k], value[k]);
        b->high[k] = fmaxf(b->high[k], value[k]);
    }
}

/* By what is known in and around a large fragment: its parts, and whatever stands at its grid's
 * places. */
static void widen_large(const full_run *r, const fixture *f, int l, uint32_t x, uint32_t y,
                        bounds *b)
{
    uint32_t half = 1u << (l - 1);
    for (uint32_t i = 0; i < 4; i++)
        widen(b, illumination(&r->m, l - 1, 2 * x + (i & 1), 2 * y + (i >> 1)));
    for (uint32_t i = 0; i < 9; i++) {
        uint32_t px = (x << l) + i % 3 * half, py = (y << l) + i / 3 * half;
        for (int level = 0; px < f->frame.width && py < f->frame.height && level < 5; level++) {
            int s = state_of(&r->m, level, px >> level, py >> level);
            if ((s != STATE_NOTHING && level < 2) || s == STATE_DARK)
                widen(b, illumination(&r->m, level, px >> level, py >> level));
        }
    }
}

/* By what is known of the pixels up to a radius. */
static void widen_around(const full_run *r, const fixture *f, int radius, int x, int y, bounds *b)
{
    for (int j = y - radius; j <= y + radius; j++)
        for (int i = x - radius; i <= x + radius; i++) {
            if (i < 0 || j < 0 || i >= (int)f->frame.width || j >= (int)f->frame.height)
                continue;
            uint32_t px = (uint32_t)i, py = (uint32_t)j;
            int l = 0;
            while (l < 4 && state_of(&r->m, l, px >> l, py >> l) == STATE_NOTHING)
                l++;
            widen(b, illumination(&r->m, l, px >> l, py >> l));
        }
}

/* Every pixel is copied, or bounded by what is known about a large fragment, or around one of 4
 * pixels or one that shares its half shadow, which are made smooth. */
static void upsampled_values_are_bounded(void **state)
{
    (void)state;
    fixture f;
    fixture_open(&f, "box_area", WIDTH, HEIGHT);
    full_run r = run_all(&f);
    int copied = 0, between = 0, shared = 0, smoothed = 0;
    for (uint32_t y = 0; y < HEIGHT; y++)
        for (uint32_t x = 0; x < WIDTH; x++) {
            const float *light = r.light + 4 * (y * WIDTH + x), *value = NULL;
            if (f.position[4 * (y * WIDTH + x) + 3] <= 0)
                continue;
            assert_true(light[3] == 1);
            int l = 0, s = STATE_NOTHING;
            for (; l < RENDER_LEVELS; l++) {
                s = state_of(&r.m, l, x >> l, y >> l);
                value = illumination(&r.m, l, x >> l, y >> l);
                if (s == STATE_DARK || s == STATE_FINAL || (l < 2 && s != STATE_NOTHING))
                    break;
            }
            assert_true(l < RENDER_LEVELS);
            bounds b = {{value[0], value[1], value[2]}, {value[0], value[1], value[2]}};
            if (s == STATE_FINAL && l > 2)
                widen_large(&r, &f, l, x >> l, y >> l, &b);
            bool part = s == STATE_PART && l == 1;
            if (s == STATE_SHARED || part)
                widen_around(&r, &f, 1 << l, (int)x, (int)y, &b);
            copied += l == 0 && s != STATE_SHARED, between += l > 2, shared += s == STATE_SHARED;
            smoothed += part && light[0] != value[0];
            for (int k = 0; k < 3; k++)
                assert_true(light[k] >= b.low[k] * 0.99999F && light[k] <= b.high[k] * 1.00001F);
        }
    assert_true(copied > 1000 && between > 1000 && shared > 200 && smoothed > 200);
    close_run(&r);
    fixture_close(&f);
}

/* ---- The 3 x 3 system (3.1.5) ---------------------------------------------------------- */

static const char radial_main[] =
    "layout(local_size_x = 64) in;\n"
    "layout(binding = 0) readonly buffer In { float x[]; };\n"
    "layout(binding = 1) writeonly buffer Out { float y[]; };\n"
    "void main() {\n"
    "    uint i = gl_GlobalInvocationID.x, b = 12u * i;\n"
    "    vec2 at[3]; vec3 v[3];\n"
    "    for (int k = 0; k < 3; k++) {\n"
    "        at[k] = vec2(x[b + 2 * k], x[b + 2 * k + 1]); v[k] = vec3(x[b + 8u + k]);\n"
    "    }\n"
    "    y[i] = radial_three(vec2(x[b + 6u], x[b + 7u]), at, v, x[b + 11u]).x;\n"
    "}\n";

/* Gauss elimination with pivots in double; then shares that add up to one, and the bounds. */
static double expect_radial(const float *x)
{
    double a[3][4], here[3], width = (double)x[11], sum = 0, value = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            double dx = (double)(x[2 * i] - x[2 * k]), dy = (double)(x[2 * i + 1] - x[2 * k + 1]);
            a[i][k] = exp(-(dx * dx + dy * dy) / (width * width) / 2);
        }
        double dx = (double)(x[6] - x[2 * i]), dy = (double)(x[7] - x[2 * i + 1]);
        a[i][3] = here[i] = exp(-(dx * dx + dy * dy) / (width * width) / 2);
    }
    double det = 1 + 2 * a[0][1] * a[0][2] * a[1][2] - a[0][1] * a[0][1] - a[0][2] * a[0][2] -
                 a[1][2] * a[1][2];
    for (int c = 0; det > 1e-4 && c < 3; c++)
        for (int i = 0; i < 3; i++) {
            double factor = i == c ? 0 : a[i][c] / a[c][c];
            for (int k = c; k < 4; k++)
                a[i][k] -= factor * a[c][k];
        }
    for (int i = 0; i < 3; i++) {
        double share = det > 1e-4 ? a[i][3] / a[i][i] : here[i];
        sum += share;
        value += share * (double)x[8 + i];
    }
    double low = fmin((double)x[8], fmin((double)x[9], (double)x[10]));
    double high = fmax((double)x[8], fmax((double)x[9], (double)x[10]));
    return fmin(fmax(value / sum, low), high);
}

static void radial_bases_take_their_values(void **state)
{
    (void)state;
    enum { COUNT = 2048 };
    gpu_device *device = open_software_device();
    gpu_shader text;
    must(render_shader_method("multires/radial.glsl", NULL, &text));
    char *source = malloc(strlen(text.source) + sizeof radial_main + 100);
    sprintf(source, "#version 450\n%s%s", strstr(text.source, "#ifndef RADIAL_GLSL"), radial_main);
    gpu_compute *compute = make_compute(
        device, &(gpu_compute_options){.name = "radial",
                                       .source = source,
                                       .binding_count = 2,
                                       .bindings = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER}});
    gpu_buffer *in = make_buffer(device, COUNT * 48), *out = make_buffer(device, COUNT * 4);
    float *x = gpu_buffer_map(in), *y = gpu_buffer_map(out);
    srand(5);
    for (int i = 0; i < COUNT; i++) {
        float *v = x + 12 * i;
        float grid[6] = {4, 4, 0, 0, 8, 0}; /* as upsample.comp has them */
        for (int k = 0; k < 8; k++)
            v[k] = i % 4 ? (float)(rand() % 1600) / 100 : k < 6 ? grid[k] : (float)(rand() % 9);
        if (i % 8 == 3) /* on one line: singular */
            v[4] = 2 * v[2] - v[0], v[5] = 2 * v[3] - v[1];
        if (i % 8 == 5) /* at a sample */
            v[6] = v[2], v[7] = v[3];
        for (int k = 8; k < 11; k++)
            v[k] = i % 16 == 4 ? 3 : (float)(rand() % 1000) / 100;
        v[11] = i % 2 ? 8 : 16;
    }
    must(gpu_dispatch_run(
        device,
        &(gpu_dispatch){.compute = compute, .resources = {in, out}, .groups = {COUNT / 64, 1, 1}}));
    int exact = 0;
    for (int i = 0; i < COUNT; i++) {
        const float *v = x + 12 * i;
        double expected = expect_radial(v);
        /* a determinant of 1e-4 loses four digits of seven */
        if (!(fabs((double)y[i] - expected) < 0.02))
            fail_msg("system %d: %g, expected %g", i, (double)y[i], expected);
        if (i % 16 == 4)
            assert_true(fabsf(y[i] - 3) < 1e-5F);
        exact += i % 8 == 5 && fabsf(y[i] - v[9]) < 0.02F;
    }
    assert_true(exact > COUNT / 8 * 3 / 4); /* of those that could be solved */
    gpu_buffer_destroy(in);
    gpu_buffer_destroy(out);
    gpu_compute_destroy(compute);
    free(source);
    free((char *)text.source);
    close_clean(device);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(large_fragments_have_three_more_samples),
        cmocka_unit_test(upsampled_values_are_bounded),
        cmocka_unit_test(radial_bases_take_their_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
