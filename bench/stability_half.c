/* stability_half.c: the range of sharpness over which half will do. */
#include <math.h>
#include <string.h>

#include "stability_private.h"

/* The ends of what half holds, apart from 0 and infinity. */
static const double least = 0x1p-24, most = 65504;

static bool spoils(const stability_row *row, const char *method)
{
    return strcmp(row->method, method) == 0 && strcmp(row->precision, "f16") == 0 &&
           (strcmp(row->kind, "error_1e-2") == 0 || strcmp(row->kind, "nan") == 0 ||
            strcmp(row->kind, "infinite") == 0);
}

/* The end of the bad ranges that hold `at`, or `at` where none does. */
static double past_bad(const stability_table *table, const char *method, double at)
{
    for (size_t i = 0; i < table->count; i++) {
        const stability_row *row = &table->rows[i];
        if (spoils(row, method) && row->lambda_from <= at && at < row->lambda_to)
            return past_bad(table, method, row->lambda_to);
    }
    return at;
}

/* Where the next bad range begins; infinity: nowhere. */
static double next_bad(const stability_table *table, const char *method, double after)
{
    double next = (double)INFINITY;
    for (size_t i = 0; i < table->count; i++) {
        const stability_row *row = &table->rows[i];
        if (spoils(row, method) && row->lambda_from > after)
            next = fmin(next, row->lambda_from);
    }
    return next;
}

static double decades(double from, double to)
{
    return log10(fmin(to, most)) - log10(fmax(from, least));
}

bool stability_half_range(const stability_table *table, const char *method, double *from,
                          double *to)
{
    bool found = false;
    double at = 0;
    while (at < most) {
        double good = past_bad(table, method, at), bad = next_bad(table, method, good);
        if (good < most && (!found || decades(good, bad) > decades(*from, *to))) {
            *from = good;
            *to = bad;
            found = true;
        }
        at = bad;
    }
    return found;
}
