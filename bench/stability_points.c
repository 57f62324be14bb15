/* stability_points.c: the two failures that are no ranges: the limit at infinity, and NaN as an
 * argument. */
#include <math.h>
#include <stdlib.h>

#include "stability_private.h"

bool stability_scan_limit(const stability_subject *subject, const stability_grid *grid,
                          stability_table *table)
{
    double tolerance = subject->precision == STABILITY_F16 ? 1e-3 : 1e-6;
    double *lambda = stability_allocate(2 * grid->cosines * sizeof *lambda);
    double *value = lambda + grid->cosines;
    for (size_t i = 0; i < grid->cosines; i++)
        lambda[i] = (double)INFINITY;
    bool good = subject->value(subject, grid->cosines, lambda, grid->cos_theta, value);
    double worst = 0, worst_severity = 0, worst_cos_theta = 0;
    for (size_t i = 0; good && i < grid->cosines; i++) {
        double limit = fmin(fmax(grid->cos_theta[i], 0), 1), error = fabs(value[i] - limit);
        double severity = isfinite(error) ? error : (double)INFINITY;
        if (severity > tolerance && severity > worst_severity) {
            worst_severity = severity;
            worst = isfinite(error) ? error : value[i];
            worst_cos_theta = grid->cos_theta[i];
        }
    }
    free(lambda);
    if (good && worst_severity > 0)
        stability_add(table,
                      &(stability_row){subject->id, stability_precision_name(subject->precision),
                                       "limit_at_infinity", (double)INFINITY, (double)INFINITY,
                                       worst, (double)INFINITY, worst_cos_theta});
    return good;
}

/* A row for each argument that can be NaN. */
bool stability_scan_nan(const stability_subject *subject, stability_table *table)
{
    static const double numbers[2][4] = {{-0.5, 0, 0.5, 1}, {1e-3, 2, 50, 1e4}};
    for (int which = 0; which < 2; which++) {
        double arguments[2][4], value[4];
        stability_row found = {.method = NULL};
        for (int i = 0; i < 4; i++) {
            arguments[which][i] = (double)NAN;
            arguments[1 - which][i] = numbers[which][i];
        }
        if (!subject->value(subject, 4, arguments[0], arguments[1], value))
            return false;
        for (int i = 0; i < 4; i++) {
            if (isnan(value[i]))
                continue;
            double from = found.method ? found.lambda_from : arguments[0][i];
            found = (stability_row){subject->id,     stability_precision_name(subject->precision),
                                    "nan_input",     from,
                                    arguments[0][i], value[i],
                                    arguments[0][i], arguments[1][i]};
        }
        if (found.method)
            stability_add(table, &found);
    }
    return true;
}
