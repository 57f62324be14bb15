/* The lobe operations of shaders/sg.glsl on the software device, against the C library's. */
#include "device_bench.h"

#include "sg.h"

/* What the lobe tests evaluate: at each point (lambda, z) a lobe of that sharpness, and another,
 * broader or sharper by turns, at that cosine from it. The same in C below. */
static const char lobes[] =
    "vec3 at(float z) { return vec3(0.6 * sqrt(1.0 - z * z), 0.8 * sqrt(1.0 - z * z), z); }\n"
    "sg_lobe first(vec2 p) { return sg_lobe(vec3(0.0, 0.0, 1.0), p.x, vec3(0.5)); }\n"
    "sg_lobe second(vec2 p) { return sg_lobe(at(p.y), 40.0, vec3(0.25)); }\n";

/* The C library's lobe operations are double: here they are given what the device has. */
static void place(float z, double axis[3])
{
    float side = sqrtf(1 - z * z);
    axis[0] = (double)(0.6F * side);
    axis[1] = (double)(0.8F * side);
    axis[2] = (double)z;
}

static sg_lobe lobe_at(float z, double sharpness, double amplitude)
{
    sg_lobe lobe = {.sharpness = sharpness, .amplitude = amplitude};
    place(z, lobe.axis);
    return lobe;
}

/* exp(-x) and x exp(-x), by which the rounding of x = |difference|^2 lambda/2 enters, are at most
 * 1: absolute 1e-6 again. The device's sqrt, 1 ulp apart, moves the direction as much; that counts
 * lambda/2 sin^2 times, hence only up to where z says exactly what the C side has. */
static void evaluation_and_integral_agree(void **state)
{
    (void)state;
    bench b = open_bench();
    const float *pairs = gpu_buffer_map(b.in), *out = gpu_buffer_map(b.out);
    run(&b, "lobe", lobes,
        "vec2(sg_evaluate_lobe(first(p), at(p.y)).x, sg_integrate_lobe(first(p)).x)");
    worst value = {0}, integral = {0};
    for (size_t i = 0; i < b.points; i++) {
        float lambda = pairs[2 * i], z = pairs[2 * i + 1];
        sg_lobe lobe = lobe_at(1, (double)lambda, 0.5);
        double direction[3];
        place(z, direction);
        compare(&value, out[2 * i], (float)sg_lobe_evaluate(&lobe, direction), tolerance, lambda,
                z);
        double expected = sg_lobe_integral(&lobe);
        compare(&integral, out[2 * i + 1], (float)expected, tolerance * expected, lambda, z);
    }
    bool good = report("sg_evaluate_lobe", "", &value);
    assert_true(report("sg_integrate_lobe", "", &integral) && good);
    close_bench(&b);
}

/* Sharpness: rounding of the sum of both. Amplitude: as for evaluation. Axis: rounding of the sum
 * of the weighted axes over its length, which shrinks where the lobes oppose each other. */
static void product_agrees(void **state)
{
    (void)state;
    bench b = open_bench();
    const float *pairs = gpu_buffer_map(b.in), *out = gpu_buffer_map(b.out);
    worst sharpness = {0}, amplitude = {0}, axis_x = {0}, axis_z = {0};
    run(&b, "product", lobes,
        "vec2(sg_product(first(p), second(p)).sharpness, sg_product(first(p), "
        "second(p)).amplitude.x)");
    for (size_t i = 0; i < b.points; i++) {
        float lambda = pairs[2 * i], z = pairs[2 * i + 1];
        sg_lobe first = lobe_at(1, (double)lambda, 0.5), second = lobe_at(z, 40, 0.25);
        sg_lobe product = sg_lobe_product(&first, &second);
        compare(&sharpness, out[2 * i], (float)product.sharpness,
                tolerance * (first.sharpness + 40), lambda, z);
        compare(&amplitude, out[2 * i + 1], (float)product.amplitude, tolerance, lambda, z);
    }
    run(&b, "product", lobes, "sg_product(first(p), second(p)).axis.xz");
    for (size_t i = 0; i < b.points; i++) {
        float lambda = pairs[2 * i], z = pairs[2 * i + 1];
        sg_lobe first = lobe_at(1, (double)lambda, 0.5), second = lobe_at(z, 40, 0.25);
        sg_lobe product = sg_lobe_product(&first, &second);
        if (product.sharpness == 0)
            continue; /* any axis */
        double bound = tolerance * (first.sharpness + 40) / product.sharpness;
        compare(&axis_x, out[2 * i], (float)product.axis[0], bound, lambda, z);
        compare(&axis_z, out[2 * i + 1], (float)product.axis[2], bound, lambda, z);
    }
    bool good = report("sg_product sharpness", "", &sharpness);
    good = report("sg_product amplitude", "", &amplitude) && good;
    good = report("sg_product axis.x", "", &axis_x) && good;
    assert_true(report("sg_product axis.z", "", &axis_z) && good);
    close_bench(&b);
}

/* sg.glsl says which method sg_irradiance calls. */
static void irradiance_agrees(void **state)
{
    (void)state;
    bench b = open_bench();
    const float *pairs = gpu_buffer_map(b.in), *out = gpu_buffer_map(b.out);
    const char *line = strstr(b.include, "sg_irradiance calls sg_A_h_");
    char id[100] = "";
    assert_non_null(line);
    assert_int_equal(sscanf(line, "sg_irradiance calls sg_A_h_%99[a-z0-9_]", id), 1);
    const sg_method *method = sg_method_find(id);
    assert_non_null(method);
    run(&b, "irradiance", lobes,
        "vec2(sg_irradiance(vec3(0.5), at(p.y), p.x, vec3(0.0, 0.0, 1.0)).y, "
        "sg_irradiance(vec3(0.0), at(p.y), p.x, vec3(0.0, 0.0, 1.0)).z)");
    worst irradiance = {0}, dark = {0};
    for (size_t i = 0; i < b.points; i++) {
        float lambda = pairs[2 * i], z = pairs[2 * i + 1];
        compare(&irradiance, out[2 * i], 0.5F * method->A_h_f32(lambda, z),
                0.5 * tolerance * sg_A((double)lambda), lambda, z);
        compare(&dark, out[2 * i + 1], 0, 0, lambda, z);
    }
    bool good = report("sg_irradiance", "", &irradiance);
    assert_true(report("sg_irradiance of nothing", "", &dark) && good);
    close_bench(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(evaluation_and_integral_agree),
        cmocka_unit_test(product_agrees),
        cmocka_unit_test(irradiance_agrees),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
