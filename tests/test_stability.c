/* sgfit stability: planted defects are found, and where; its files are what they are said to be. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/exr.h"
#include "base/file.h"
#include "bench/stability.h"
#include "program.h"
#include "workspace.h"

static const sg_method *sound(void)
{
    const sg_method *method = sg_method_find("tokuyoshi_2024_stable");
    assert_non_null(method);
    return method;
}

/* ---- Defects ----------------------------------------------------------------------------------
 */

static double wrong_f64(double lambda, double z)
{
    double off = lambda > 200 && lambda < 230 && z < -0.9 ? -2e-2 : 0;
    return sound()->L_f64(lambda, z) + off;
}

static float nan_f32(float lambda, float z)
{
    return lambda > 3.3F && lambda < 3.5F && z > 0.2F ? NAN : sound()->L_f32(lambda, z);
}

static float rounding_f32(float lambda, float z)
{
    float value = sound()->L_f32(lambda, z);
    return lambda > 1e5F && lambda < 3e5F ? value + 2e-6F : value;
}

static float infinite_f32(float lambda, float z)
{
    return lambda > 40 && lambda < 80 ? INFINITY : sound()->L_f32(lambda, z);
}

static float above_f32(float lambda, float z)
{
    return lambda > 40 && lambda < 80 && z > 0.9F ? 1.01F : sound()->L_f32(lambda, z);
}

/* Denormal sharpnesses matter where they should not. */
static float flushed_f32(float lambda, float z)
{
    volatile float product = lambda * 0.5F;
    return product > 0 || lambda == 0 || lambda >= FLT_MIN ? sound()->L_f32(lambda, z) : 0.5F;
}

/* Bends at 1.7 and is wrong for a few floats right after. */
static const double seam = 1.7;
static double bent_f64(double lambda, double z)
{
    return sound()->L_f64(lambda, z) + (lambda > seam ? 1e-3 * log(lambda / seam) : 0);
}
static float bent_f32(float lambda, float z)
{
    bool wrong = (double)lambda > seam && (double)lambda < seam + 3e-7;
    return wrong ? NAN : (float)bent_f64((double)lambda, (double)z);
}

static double keeps_no_nan(double lambda, double z)
{
    return isnan(lambda) || isnan(z) ? 0.25 : sound()->L_f64(lambda, z);
}

static double ends_at_half(double lambda, double z)
{
    return isinf(lambda) ? 0.5 : sound()->L_f64(lambda, z);
}

static stability_table scanned(const sg_method *method, stability_precision precision,
                               const stability_seams *seams)
{
    static stability_grid *grids[STABILITY_PRECISIONS];
    if (!grids[precision])
        grids[precision] = stability_grid_new(precision, false);
    stability_subject subject;
    stability_table table = {0};
    assert_true(stability_method_subject(method, precision, &subject));
    assert_true(stability_scan(&subject, grids[precision], seams, &table));
    return table;
}

static const stability_row *find(const stability_table *table, const char *kind)
{
    for (size_t i = 0; i < table->count; i++)
        if (strcmp(table->rows[i].kind, kind) == 0)
            return &table->rows[i];
    return NULL;
}

/* A row of that kind whose ends are within 1 % of the true ones, and no other of the kind. */
static void assert_found(sg_method method, stability_precision precision, const char *kind,
                         double from, double to)
{
    stability_table table = scanned(&method, precision, NULL);
    stability_table clean = scanned(sound(), precision, NULL);
    if (find(&clean, kind))
        fail_msg("the sound method has %s too", kind);
    const stability_row *row = find(&table, kind);
    if (!row)
        fail_msg("%s in [%g, %g] is not found", kind, from, to);
    print_message("%-14s [%.6g, %.6g], worst %g at (%g, %g)\n", kind, row->lambda_from,
                  row->lambda_to, row->worst, row->worst_lambda, row->worst_cos_theta);
    if (!(fabs(row->lambda_from / from - 1) < 0.01 && fabs(row->lambda_to / to - 1) < 0.01))
        fail_msg("%s: expected [%g, %g]", kind, from, to);
    assert_true(row->worst_lambda >= row->lambda_from && row->worst_lambda <= row->lambda_to);
    int count = 0;
    for (size_t i = 0; i < table.count; i++)
        count += strcmp(table.rows[i].kind, kind) == 0;
    assert_int_equal(count, 1);
    stability_table_free(&table);
    stability_table_free(&clean);
}

static sg_method planted(void)
{
    sg_method method = *sound();
    method.id = "planted";
    return method;
}

static void narrow_bands_are_found(void **state)
{
    (void)state;
    sg_method method = planted();
    method.L_f64 = wrong_f64;
    assert_found(method, STABILITY_F64, "negative", 200, 230);
    assert_found(method, STABILITY_F64, "error_1e-2", 200, 230);
    method = planted();
    method.L_f32 = nan_f32;
    assert_found(method, STABILITY_F32, "nan", 3.3, 3.5);
    method.L_f32 = rounding_f32;
    assert_found(method, STABILITY_F32, "rounding_1e-6", 1e5, 3e5);
    method.L_f32 = infinite_f32;
    assert_found(method, STABILITY_F32, "infinite", 40, 80);
    method.L_f32 = above_f32;
    assert_found(method, STABILITY_F32, "above_one", 40, 80);
}

static void a_defect_at_a_seam_is_found(void **state)
{
    (void)state;
    sg_method method = planted();
    method.L_f64 = bent_f64;
    method.L_f32 = bent_f32;
    stability_seams seams = {0};
    stability_seams_in_values(bent_f64, STABILITY_F32, &seams);
    assert_true(seams.count > 0);
    stability_table with = scanned(&method, STABILITY_F32, &seams);
    stability_table without = scanned(&method, STABILITY_F32, NULL);
    assert_null(find(&without, "nan")); /* or this would be no test of seams */
    const stability_row *row = find(&with, "nan");
    assert_non_null(row);
    print_message("seam at %.9g: NaN in [%.9g, %.9g]\n", seam, row->lambda_from, row->lambda_to);
    assert_true(row->lambda_from > seam && row->lambda_to < seam + 3e-7);
    stability_table_free(&with);
    stability_table_free(&without);
    stability_seams_free(&seams);
}

static void single_points_are_found(void **state)
{
    (void)state;
    sg_method method = planted();
    method.L_f64 = keeps_no_nan;
    stability_table table = scanned(&method, STABILITY_F64, NULL);
    const stability_row *row = find(&table, "nan_input");
    assert_non_null(row);
    assert_true(row->worst == 0.25);
    stability_table_free(&table);
    method.L_f64 = ends_at_half;
    table = scanned(&method, STABILITY_F64, NULL);
    row = find(&table, "limit_at_infinity");
    assert_non_null(row);
    assert_true(isinf(row->lambda_from) && fabs(row->worst - 0.5) < 1e-9);
    stability_table_free(&table);
}

#if defined(__SSE__)
static void flushed_denormals_are_found(void **state)
{
    (void)state;
    sg_method method = planted();
    method.L_f32 = flushed_f32;
    stability_table table = scanned(&method, STABILITY_F32, NULL);
    const stability_row *row = find(&table, "flushed");
    assert_non_null(row);
    assert_true(row->lambda_to <= 1.0001 * (double)FLT_MIN * 2);
    stability_table_free(&table);
}
#endif

/* ---- The program ------------------------------------------------------------------------------
 */

static void the_files_are_as_said(void **state)
{
    (void)state;
    static const char header[] =
        "method,precision,kind,lambda_from,lambda_to,worst,worst_lambda,worst_cos_theta\n";
    workspace work;
    workspace_open(&work);
    run r = program_run((const char *[]){"stability", "--quick", "--method", "meder_2018", "--out",
                                         work.folder, "--device", "no such device", NULL},
                        NULL);
    assert_int_equal(r.status, 0);
    run_free(&r);
    char *text = base_read_file(workspace_path(&work, "failures.csv"), NULL);
    assert_non_null(text);
    assert_memory_equal(text, header, sizeof header - 1);
    const char *row = strstr(text, "\nmeder_2018,f32,nan,88.7");
    assert_non_null(row); /* from where e^lambda overflows */
    assert_null(strstr(text, ",device,"));
    free(text);
    int width, height;
    float *map =
        exr_read(workspace_path(&work, "maps/meder_2018_f32.exr"), "mark", &width, &height);
    assert_non_null(map);
    assert_int_equal(width, STABILITY_MAP_WIDTH);
    assert_int_equal(height, STABILITY_MAP_HEIGHT);
    assert_true(map[width - 1] == (float)STABILITY_NAN);
    free(map);
    size_t size;
    text = base_read_file(workspace_path(&work, "maps/meder_2018_f32.png"), &size);
    assert_non_null(text);
    assert_true(size > 100 && memcmp(text, "\x89PNG\r\n\x1a\n", 8) == 0);
    free(text);
    workspace_close(&work);
}

static void wrong_use_is_one_line(void **state)
{
    (void)state;
    static const char *const lines[][5] = {{"stability", NULL},
                                           {"stability", "--out", "x", "--method=none", NULL}};
    for (size_t i = 0; i < 2; i++) {
        run r = program_run(lines[i], NULL);
        assert_int_equal(r.status, 2);
        assert_true(strchr(r.error, '\n') == r.error + strlen(r.error) - 1);
        run_free(&r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(narrow_bands_are_found),
        cmocka_unit_test(a_defect_at_a_seam_is_found),
        cmocka_unit_test(single_points_are_found),
#if defined(__SSE__)
        cmocka_unit_test(flushed_denormals_are_found),
#endif
        cmocka_unit_test(the_files_are_as_said),
        cmocka_unit_test(wrong_use_is_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
