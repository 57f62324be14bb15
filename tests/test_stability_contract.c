/* sgfit stability: the methods that promise to be stable are. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#include "base/progress.h"
#include "bench/stability.h"

typedef struct contract {
    stability_grid *grids[STABILITY_PRECISIONS];
    stability_table tables[1024];
    bool good[1024];
} contract;

static void scan_method(void *context, size_t index)
{
    contract *all = context;
    const sg_method *method = sg_method_at(index / 2);
    stability_precision precision = index % 2 ? STABILITY_F32 : STABILITY_F64;
    stability_subject subject;
    stability_seams seams = {0};
    all->good[index] = true;
    if (strcmp(method->variant, "published") == 0)
        return;
    stability_seams_in_values(method->L_f64, precision, &seams);
    all->good[index] = stability_method_subject(method, precision, &subject) &&
                       stability_scan(&subject, all->grids[precision], &seams, &all->tables[index]);
    stability_seams_free(&seams);
}

/* Everything but a published text: no NaN and no infinity, in [0, 1], rounding below 1e-6, NaN for
 * NaN, max(z, 0) at infinity, the same where denormals are flushed. Only the model may be off. */
static void what_promises_to_be_stable_is(void **state)
{
    (void)state;
    contract *all = calloc(1, sizeof *all);
    assert_non_null(all);
    assert_true(2 * sg_method_count() <= sizeof all->tables / sizeof all->tables[0]);
    for (int p = STABILITY_F64; p <= STABILITY_F32; p++)
        all->grids[p] = stability_grid_new((stability_precision)p, true);
    base_parallel(2 * sg_method_count(), scan_method, all);
    int broken = 0;
    for (size_t i = 0; i < 2 * sg_method_count(); i++) {
        assert_true(all->good[i]);
        for (size_t k = 0; k < all->tables[i].count; k++) {
            const stability_row *r = &all->tables[i].rows[k];
            if (strncmp(r->kind, "error", 5) == 0)
                continue;
            print_message("%s, %s: %s in [%.9g, %.9g], worst %.9g at (%.9g, %.9g)\n", r->method,
                          r->precision, r->kind, r->lambda_from, r->lambda_to, r->worst,
                          r->worst_lambda, r->worst_cos_theta);
            broken++;
        }
        stability_table_free(&all->tables[i]);
    }
    for (int p = STABILITY_F64; p <= STABILITY_F32; p++)
        stability_grid_free(all->grids[p]);
    free(all);
    assert_int_equal(broken, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_promises_to_be_stable_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
