/* stability_operations.c: the lobe product, the moment conversions and sums of many lobes as
 * subjects of the scan. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/progress.h"
#include "stability_cores.h"
#include "stability_private.h"

static bool core_value(const stability_subject *subject, size_t n, const double *lambda,
                       const double *cos_theta, double *out)
{
    const stability_core *core = subject->context;
    for (size_t i = 0; i < n; i++)
        out[i] = core->value(lambda[i], cos_theta[i]);
    return true;
}

static bool core_truth(const stability_subject *subject, size_t n, const double *lambda,
                       const double *cos_theta, double *out)
{
    const stability_core *core = subject->context;
    for (size_t i = 0; i < n; i++)
        out[i] = core->truth ? core->truth(lambda[i], cos_theta[i]) : (double)NAN;
    return true;
}

/* ---- Sums -------------------------------------------------------------------------------------
 */

/* L of `count` lobes of one sharpness whose axes lie about cos_theta, added up one after the other
 * or pairwise, over the sum of the same terms in double; 1 where there is nothing to add. */
typedef struct sum {
    const char *id;
    int count;
    bool pairwise;
} sum;

static const sum sums[] = {{"sum_of_16", 16, false},
                           {"sum_of_256", 256, false},
                           {"sum_of_4096", 4096, false},
                           {"sum_of_4096_pairwise", 4096, true}};
enum { SUMS = sizeof sums / sizeof *sums, MOST_TERMS = 4096 };

static double add_up(stability_precision precision, const sum *s, double *terms)
{
    double total = 0;
    if (!s->pairwise) {
        for (int i = 0; i < s->count; i++)
            total = stability_rounded(precision, total + terms[i]);
        return total;
    }
    for (int half = s->count / 2; half > 0; half /= 2)
        for (int i = 0; i < half; i++)
            terms[i] = stability_rounded(precision, terms[i] + terms[i + half]);
    return terms[0];
}

static double sum_at(const stability_subject *subject, const sg_method *method, double lambda,
                     double cos_theta)
{
    const sum *s = subject->context;
    double terms[MOST_TERMS], exact = 0;
    for (int i = 0; i < s->count; i++) {
        double z = fmin(fmax(cos_theta + 0.1 * (fmod(i * 0.6180339887498949, 1) - 0.5), -1), 1);
        terms[i] = subject->precision == STABILITY_F16
                       ? (double)method->L_f16((float)lambda, (float)z)
                       : (double)method->L_f32((float)lambda, (float)z);
        exact += terms[i];
    }
    return exact > 0 ? add_up(subject->precision, s, terms) / exact : 1;
}

static bool sum_value(const stability_subject *subject, size_t n, const double *lambda,
                      const double *cos_theta, double *out)
{
    const sg_method *method = sg_method_find("tokuyoshi_2024_stable");
    for (size_t i = 0; i < n; i++)
        out[i] = isnan(lambda[i]) || isnan(cos_theta[i])
                     ? (double)NAN
                     : sum_at(subject, method, lambda[i], cos_theta[i]);
    return true;
}

static bool sum_truth(const stability_subject *subject, size_t n, const double *lambda,
                      const double *cos_theta, double *out)
{
    (void)subject;
    for (size_t i = 0; i < n; i++)
        out[i] = truth_one(lambda[i], cos_theta[i]);
    return true;
}

/* ---- All of them ------------------------------------------------------------------------------
 */

enum { MOST_SUBJECTS = 64 };

typedef struct operations {
    stability_subject subjects[MOST_SUBJECTS];
    stability_table tables[MOST_SUBJECTS];
    bool good[MOST_SUBJECTS];
    stability_grid *grids[STABILITY_PRECISIONS], *thin[STABILITY_PRECISIONS];
    size_t count;
} operations;

static void operation_job(void *context, size_t index)
{
    operations *all = context;
    const stability_subject *subject = &all->subjects[index];
    bool heavy = subject->value == sum_value;
    const stability_grid *grid = (heavy ? all->thin : all->grids)[subject->precision];
    all->good[index] = stability_scan(subject, grid, NULL, &all->tables[index]);
}

/* Every so many of a list, and the last. */
static size_t thin_out(double *list, size_t count, size_t step)
{
    size_t kept = 0;
    for (size_t i = 0; i + 1 < count; i += step)
        list[kept++] = list[i];
    list[kept++] = list[count - 1];
    return kept;
}

/* For thousands of terms a point. */
static stability_grid *thin_grid(stability_precision precision)
{
    stability_grid *grid = stability_grid_new(precision, true);
    grid->lambdas = thin_out(grid->lambda, grid->lambdas, 4);
    grid->cosines = thin_out(grid->cos_theta, grid->cosines, 10);
    return grid; /* its truth is not that of these points any more, and not asked for */
}

static void add_subjects(operations *all, stability_precision precision,
                         const stability_core *cores)
{
    for (const stability_core *core = cores; core->id; core++)
        all->subjects[all->count++] = (stability_subject){.id = core->id,
                                                          .precision = precision,
                                                          .value = core_value,
                                                          .truth = core_truth,
                                                          .context = core,
                                                          .any_size = !core->in_unit};
    bool has = precision == STABILITY_F32 ||
               (precision == STABILITY_F16 && sg_method_find("tokuyoshi_2024_stable")->L_f16);
    for (int i = 0; has && i < SUMS; i++)
        all->subjects[all->count++] = (stability_subject){.id = sums[i].id,
                                                          .precision = precision,
                                                          .value = sum_value,
                                                          .truth = sum_truth,
                                                          .context = &sums[i],
                                                          .any_size = true};
}

bool stability_operations(stability_table *table)
{
    static const stability_core *const cores[] = {stability_cores_f64, stability_cores_f32,
                                                  stability_cores_f16};
    operations *all = calloc(1, sizeof *all);
    if (!all)
        abort();
    for (int p = STABILITY_F64; p <= STABILITY_F16; p++) {
        all->grids[p] = stability_grid_new((stability_precision)p, true);
        all->thin[p] = thin_grid((stability_precision)p);
        add_subjects(all, (stability_precision)p, cores[p]);
    }
    base_parallel(all->count, operation_job, all);
    bool good = true;
    for (size_t i = 0; i < all->count; i++) {
        good = good && all->good[i];
        for (size_t k = 0; k < all->tables[i].count; k++)
            stability_add(table, &all->tables[i].rows[k]);
        stability_table_free(&all->tables[i]);
    }
    for (int p = STABILITY_F64; p <= STABILITY_F16; p++) {
        stability_grid_free(all->grids[p]);
        stability_grid_free(all->thin[p]);
    }
    free(all);
    return good;
}
