/* device_bench.h: functions of shaders/sg.glsl on the software device, at many points, and the
 * comparison of what they give with C. Each test program includes it once. */
#ifndef DEVICE_BENCH_H
#define DEVICE_BENCH_H

#include "gpu_fixture.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/file.h"

enum { POINTS = 100000, GROUP = 64 };

/* Of L; see test_device_agreement.c. */
static const double tolerance = 1e-6;

static char *include_text(void)
{
    const char *root = getenv("SGFIT_ROOT");
    assert_non_null(root);
    char *path = base_join(root, "shaders/sg.glsl");
    char *text = base_read_file(path, NULL);
    free(path);
    assert_non_null(text);
    return text;
}

/* Half of the points over all of float's useful range, half where the curves bend; then the
 * extremes of both arguments, combined. Returns how many. */
static size_t fill_points(float *pairs)
{
    static const float lambdas[] = {
        0,    1e-45F, 1e-40F, 1.17549435e-38F, 1e-30F, 1e-20F, 1e-10F, 1e-7F, 1e-5F, 1e-3F,
        0.1F, 1,      10,     88.7F,           100,    1e4F,   1e6F,   1e10F, 1e20F, 1e30F};
    static const float cosines[] = {-1,     -0.99999994F, -0.5F, -1e-3F, -1e-20F,     -1e-45F, 0,
                                    1e-45F, 1e-20F,       1e-3F, 0.5F,   0.99999994F, 1};
    double x = 0.5, y = 0.5;
    size_t n = 0;
    for (; n < POINTS; n++) {
        x = fmod(x + 0.7548776662466927, 1);
        y = fmod(y + 0.5698402909980532, 1);
        pairs[2 * n] = (float)pow(10, n % 2 ? 9 * x - 4 : 60 * x - 30);
        pairs[2 * n + 1] = (float)(2 * y - 1);
    }
    for (size_t i = 0; i < sizeof lambdas / sizeof *lambdas; i++)
        for (size_t j = 0; j < sizeof cosines / sizeof *cosines; j++, n++) {
            pairs[2 * n] = lambdas[i];
            pairs[2 * n + 1] = cosines[j];
        }
    return n;
}

typedef struct bench {
    gpu_device *device;
    gpu_buffer *in, *out;
    char *include;
    size_t points;
} bench;

static bench open_bench(void)
{
    bench b = {.device = open_software_device(), .include = include_text()};
    const size_t capacity = POINTS + 1024;
    assert_int_equal(gpu_buffer_create(b.device, capacity * 2 * sizeof(float), &b.in), GPU_OK);
    assert_int_equal(gpu_buffer_create(b.device, capacity * 2 * sizeof(float), &b.out), GPU_OK);
    b.points = fill_points(gpu_buffer_map(b.in));
    return b;
}

static void close_bench(bench *b)
{
    gpu_buffer_destroy(b->in);
    gpu_buffer_destroy(b->out);
    free(b->include);
    close_clean(b->device);
}

/* Runs an expression of `p` (lambda, cos_theta) that gives a vec2, at every point; declarations
 * come before it. */
static void run(bench *b, const char *name, const char *declarations, const char *expression)
{
    static const char before[] = "#version 450\n"
                                 "layout(local_size_x = 64) in;\n"
                                 "layout(std430, binding = 0) readonly buffer A { vec2 a[]; };\n"
                                 "layout(std430, binding = 1) writeonly buffer B { vec2 b[]; };\n"
                                 "#line 1\n";
    size_t size =
        sizeof before + strlen(declarations) + strlen(b->include) + strlen(expression) + 200;
    char *source = malloc(size);
    assert_non_null(source);
    snprintf(
        source, size,
        "%s%s\n%svoid main() { uint i = gl_GlobalInvocationID.x; vec2 p = a[i]; b[i] = %s; }\n",
        before, b->include, declarations, expression);
    gpu_compute *compute;
    gpu_compute_options options = {.name = name, .source = source, .binding_count = 2};
    if (gpu_compute_create(b->device, &options, &compute) != GPU_OK)
        fail_msg("%s", gpu_last_error());
    gpu_dispatch dispatch = {.compute = compute,
                             .resources = {b->in, b->out},
                             .groups = {(uint32_t)((b->points + GROUP - 1) / GROUP)}};
    if (gpu_dispatch_run(b->device, &dispatch) != GPU_OK)
        fail_msg("%s", gpu_last_error());
    gpu_compute_destroy(compute);
    free(source);
}

/* The worst difference over what is allowed, and where. */
typedef struct worst {
    double ratio, difference;
    float lambda, cos_theta, device, host;
} worst;

static void compare(worst *w, float device, float host, double bound, float lambda, float cos_theta)
{
    double difference = fabs((double)device - (double)host);
    double ratio = difference / (bound + 2 * (double)FLT_MIN);
    if (!(ratio <= w->ratio)) /* NaN is worst of all */
        *w = (worst){
            isnan(ratio) ? (double)INFINITY : ratio, difference, lambda, cos_theta, device, host};
}

static bool report(const char *id, const char *quantity, const worst *w)
{
    print_message("%s %-3s %-32s difference %.2g, %.2g of what is allowed, at (%.9g, %.9g): "
                  "device %.9g, C %.9g\n",
                  w->ratio <= 1 ? "PASS" : "FAIL", quantity, id, w->difference, w->ratio,
                  (double)w->lambda, (double)w->cos_theta, (double)w->device, (double)w->host);
    return w->ratio <= 1;
}

#endif
