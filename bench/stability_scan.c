/* stability_scan.c: from points to ranges: judges every row of the grid (one sharpness, all
 * cosines), joins failing rows to ranges, and moves the ends of each to where it begins and stops.
 *
 * The ends of all ranges are bisected together, a step of each at a time: a device is asked a few
 * times for many points, not often for a few. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "stability_private.h"

/* Good sharpnesses within a factor of told_apart, or at most GOOD_ROWS of them in a row, between
 * failing ones are no gap: a cancellation comes and goes with every rounding. */
static const double told_apart = 10;
enum { GOOD_ROWS = 2 };
static const double end_tolerance = 1e-6; /* relative, of an end */
enum { POINTS_AT_ONCE = 1 << 16, ROUNDS_MAX = 64 };

typedef struct finding {
    double severity, worst, lambda, cos_theta; /* severity 0: nothing */
} finding;

/* One sharpness. */
typedef struct row {
    double lambda;
    const double *truth;        /* at the grid's cosines; NULL: to be computed */
    const stability_seam *seam; /* whose cosines are looked at besides the grid's; may be NULL */
    finding kinds[STABILITY_KINDS];
} row;

typedef struct range {
    int kind;
    double from, to;     /* failing */
    double below, above; /* the good sharpnesses next to them; NaN: there are none */
    finding worst;
} range;

typedef struct scan {
    const stability_subject *subject;
    const stability_grid *grid;
    row *rows;
    size_t row_count;
    range *ranges;
    size_t range_count;
} scan;

static size_t points_of(const scan *s, const row *r)
{
    return s->grid->cosines + (r->seam ? r->seam->count : 0);
}

static void consider(finding *found, double severity, double worst, double lambda, double cos_theta)
{
    if (severity > found->severity)
        *found = (finding){severity, worst, lambda, cos_theta};
}

static void judge_row(const scan *s, row *r, const stability_values *values, size_t first,
                      const double *cos_theta)
{
    for (size_t i = first; i < first + points_of(s, r); i++)
        for (int kind = 0; kind < STABILITY_KINDS; kind++) {
            double worst = 0;
            double severity = stability_severity(kind, s->subject, values, i, &worst);
            consider(&r->kinds[kind], severity, worst, r->lambda, cos_theta[i]);
        }
}

/* The points of a row, with what is known of their truth. */
static void place(const scan *s, const row *r, double *lambda, double *cos_theta, double *truth)
{
    size_t n = points_of(s, r), cosines = s->grid->cosines;
    for (size_t i = 0; i < n; i++)
        lambda[i] = r->lambda;
    memcpy(cos_theta, s->grid->cos_theta, cosines * sizeof *cos_theta);
    for (size_t i = cosines; i < n; i++)
        cos_theta[i] = r->seam->cos_theta[i - cosines];
    if (s->subject->truth)
        return;
    size_t known = r->truth ? cosines : 0;
    if (known)
        memcpy(truth, r->truth, known * sizeof *truth);
    sg_L_cos_batch(n - known, lambda + known, cos_theta + known, truth + known);
}

/* Judges as many rows as go at once. */
static bool judge_rows(const scan *s, row *rows, size_t count)
{
    size_t n = 0, at = 0;
    for (size_t i = 0; i < count; i++)
        n += points_of(s, &rows[i]);
    double *lambda = stability_allocate(3 * n * sizeof *lambda);
    double *cos_theta = lambda + n, *truth = lambda + 2 * n;
    for (size_t i = 0; i < count; at += points_of(s, &rows[i++]))
        place(s, &rows[i], lambda + at, cos_theta + at, truth + at);
    stability_values values;
    bool good = stability_evaluate(s->subject, n, lambda, cos_theta, truth, &values);
    at = 0;
    for (size_t i = 0; good && i < count; at += points_of(s, &rows[i++]))
        judge_row(s, &rows[i], &values, at, cos_theta);
    stability_values_free(&values);
    free(lambda);
    return good;
}

static bool judge_all(const scan *s, row *rows, size_t count)
{
    size_t most = POINTS_AT_ONCE / (s->grid->cosines + 1) + 1;
    for (size_t i = 0; i < count; i += most)
        if (!judge_rows(s, rows + i, count - i < most ? count - i : most))
            return false;
    return true;
}

/* ---- Rows and ranges --------------------------------------------------------------------------
 */

static int by_lambda(const void *a, const void *b)
{
    double x = ((const row *)a)->lambda, y = ((const row *)b)->lambda;
    return (x > y) - (x < y);
}

static void make_rows(scan *s, const stability_seams *seams)
{
    const stability_grid *grid = s->grid;
    size_t extra = seams ? seams->count : 0;
    s->rows = calloc(grid->lambdas + extra, sizeof *s->rows);
    if (!s->rows)
        abort();
    for (size_t i = 0; i < grid->lambdas; i++)
        s->rows[s->row_count++] =
            (row){.lambda = grid->lambda[i], .truth = grid->truth + i * grid->cosines};
    for (size_t i = 0; i < extra; i++)
        s->rows[s->row_count++] = (row){.lambda = seams->list[i].lambda, .seam = &seams->list[i]};
    qsort(s->rows, s->row_count, sizeof *s->rows, by_lambda);
}

static void join_rows(scan *s, int kind)
{
    range *last = NULL;
    size_t last_row = 0;
    for (size_t i = 0; i < s->row_count; i++) {
        const row *r = &s->rows[i];
        const finding *found = &r->kinds[kind];
        if (!(found->severity > 0))
            continue;
        if (!last || (r->lambda > told_apart * last->to && i > last_row + 1 + GOOD_ROWS)) {
            s->ranges = realloc(s->ranges, (s->range_count + 1) * sizeof *s->ranges);
            if (!s->ranges)
                abort();
            last = &s->ranges[s->range_count++];
            *last = (range){.kind = kind, .from = r->lambda};
            last->below = i ? s->rows[i - 1].lambda : (double)NAN;
        }
        last_row = i;
        last->to = r->lambda;
        last->above = i + 1 < s->row_count ? s->rows[i + 1].lambda : (double)NAN;
        consider(&last->worst, found->severity, found->worst, found->lambda, found->cos_theta);
    }
}

/* ---- Ends -------------------------------------------------------------------------------------
 */

/* Between two sharpnesses by their bits, which is close to the geometric mean and needs no care at
 * 0, among the denormals and at infinity. */
static double between(stability_precision precision, double a, double b)
{
    uint64_t x, y;
    memcpy(&x, &a, sizeof x);
    memcpy(&y, &b, sizeof y);
    x = x < y ? x + (y - x) / 2 : y + (x - y) / 2;
    memcpy(&a, &x, sizeof a);
    return stability_rounded(precision, a);
}

static bool is_open(double good, double bad, double middle)
{
    return !isnan(good) && middle != good && middle != bad &&
           fabs(good - bad) > end_tolerance * bad;
}

typedef struct end {
    double *good, *bad;
    range *range;
} end;

/* A step of every end that is still open; their number, or -1. */
static long step(scan *s, end *ends, size_t count)
{
    row *rows = calloc(count + 1, sizeof *rows);
    end *open = calloc(count + 1, sizeof *open);
    if (!rows || !open)
        abort();
    size_t n = 0;
    for (size_t i = 0; i < count; i++) {
        double middle = isnan(*ends[i].good)
                            ? (double)NAN
                            : between(s->subject->precision, *ends[i].good, *ends[i].bad);
        if (!is_open(*ends[i].good, *ends[i].bad, middle))
            continue;
        rows[n].lambda = middle;
        open[n++] = ends[i];
    }
    bool good = judge_all(s, rows, n);
    for (size_t i = 0; i < n; i++) {
        const finding *found = &rows[i].kinds[open[i].range->kind];
        *(found->severity > 0 ? open[i].bad : open[i].good) = rows[i].lambda;
        consider(&open[i].range->worst, found->severity, found->worst, found->lambda,
                 found->cos_theta);
    }
    free(rows);
    free(open);
    return good ? (long)n : -1;
}

static bool find_ends(scan *s)
{
    end *ends = stability_allocate(2 * s->range_count * sizeof *ends);
    for (size_t i = 0; i < s->range_count; i++) {
        range *r = &s->ranges[i];
        ends[2 * i] = (end){&r->below, &r->from, r};
        ends[2 * i + 1] = (end){&r->above, &r->to, r};
    }
    long open = 1;
    for (int i = 0; i < ROUNDS_MAX && open > 0; i++)
        open = step(s, ends, 2 * s->range_count);
    free(ends);
    return open >= 0;
}

bool stability_scan(const stability_subject *subject, const stability_grid *grid,
                    const stability_seams *seams, stability_table *table)
{
    scan s = {.subject = subject, .grid = grid};
    make_rows(&s, seams);
    bool good = judge_all(&s, s.rows, s.row_count);
    for (int kind = 0; good && kind < STABILITY_KINDS; kind++)
        join_rows(&s, kind);
    good = good && find_ends(&s);
    for (size_t i = 0; good && i < s.range_count; i++) {
        const range *r = &s.ranges[i];
        stability_add(table,
                      &(stability_row){subject->id, stability_precision_name(subject->precision),
                                       stability_kind_name(r->kind), r->from, r->to, r->worst.worst,
                                       r->worst.lambda, r->worst.cos_theta});
    }
    /* operations have their own truth, and other limits */
    if (!subject->truth)
        good = good && stability_scan_limit(subject, grid, table) &&
               stability_scan_nan(subject, table);
    free(s.rows);
    free(s.ranges);
    return good;
}
