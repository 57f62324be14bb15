/* report_routes.c: the textbook quadrature routes against the reference: what each claims, what
 * its error is, and where it fails. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/progress.h"
#include "base/text.h"
#include "html.h"
#include "report.h"

enum { SHARPNESSES = 10, ANGLES = 8 };

static const double sharpness[SHARPNESSES] = {1e-3, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e8};
static const double angle[ANGLES] = {0.0, 0.5, 1.2, 1.5, 1.7, 2.2, 2.8, 3.141592653589793};

/* Below this the truth has left the range in which a relative error is meaningful in double. */
static const double smallest = 1e-290;
static const double failed = 1e-3;

typedef struct outcome {
    double truth;
    sg_quadrature result;
    sg_status status;
} outcome;

static void evaluate(void *context, size_t index)
{
    outcome *o = (outcome *)context + index;
    size_t point = index % (SHARPNESSES * ANGLES);
    double lambda = sharpness[point / ANGLES], beta = angle[point % ANGLES];
    o->truth = sg_A_h(lambda, beta);
    o->status = sg_route_at(index / (SHARPNESSES * ANGLES))->A_h(lambda, beta, &o->result);
}

static double relative(const outcome *o)
{
    if (o->truth < smallest)
        return -1.0;
    double error = fabs(o->result.value - o->truth) / o->truth;
    return isfinite(error) ? error : (double)INFINITY;
}

/* The claim, relative to the route's own value: 0 of 0 is a claim of 0. */
static double claimed(const outcome *o)
{
    return o->result.claimed_error == 0.0 ? 0.0 : o->result.claimed_error / fabs(o->result.value);
}

static const outcome *at(const outcome *all, size_t route, size_t s, size_t a)
{
    return &all[(route * SHARPNESSES + s) * ANGLES + a];
}

static void write_csv(report *report, const outcome *all)
{
    FILE *out = page_file_begin(report->page, "data/routes.csv");
    char text[5][BASE_NUMBER_SIZE];
    fputs("route,lambda,beta,A_h,value,relative_error,claimed_relative_error,evaluations,status\n",
          out);
    for (size_t r = 0; r < sg_route_count(); r++)
        for (size_t s = 0; s < SHARPNESSES; s++)
            for (size_t a = 0; a < ANGLES; a++) {
                const outcome *o = at(all, r, s, a);
                double error = relative(o);
                fprintf(out, "%s,%s,%s,%s,%s,%s,", sg_route_at(r)->id,
                        base_shortest_f64(sharpness[s], text[0]),
                        base_shortest_f64(angle[a], text[1]), base_shortest_f64(o->truth, text[2]),
                        base_shortest_f64(o->result.value, text[3]),
                        error < 0.0 ? "" : base_shortest_f64(error, text[4]));
                fprintf(out, "%s,%ld,%s\n", base_shortest_f64(claimed(o), text[0]),
                        o->result.evaluations, sg_status_string(o->status));
            }
    page_file_end(report->page);
}

/* One cell: the worst over the angles, its place and the claim in the tooltip. */
static void write_cell(page *page, const outcome *all, size_t route, size_t s)
{
    double worst = -1.0;
    size_t where = 0;
    for (size_t a = 0; a < ANGLES; a++) {
        double error = relative(at(all, route, s, a));
        if (error > worst) {
            worst = error;
            where = a;
        }
    }
    const outcome *o = at(all, route, s, where);
    char tooltip[200], numbers[4][HTML_NUMBER_SIZE];
    snprintf(tooltip, sizeof tooltip, "β = %s: %s instead of %s; claimed relative error %s",
             html_number(angle[where], 3, numbers[0]), html_number(o->result.value, 3, numbers[1]),
             html_number(o->truth, 3, numbers[2]), html_number(claimed(o), 1, numbers[3]));
    html_cell_marked(page, worst, 1, worst > failed ? "bad" : "good", tooltip);
}

static void write_overview(report *report, const outcome *all)
{
    char headers[SHARPNESSES][HTML_NUMBER_SIZE + 8], number[HTML_NUMBER_SIZE];
    const char *columns[SHARPNESSES + 2] = {"route"};
    for (size_t s = 0; s < SHARPNESSES; s++) {
        snprintf(headers[s], sizeof headers[s], "#λ = %s", html_number(sharpness[s], 1, number));
        columns[1 + s] = headers[s];
    }
    columns[1 + SHARPNESSES] = NULL;
    html_table_begin(report->page,
                     "Largest relative error over eight angles from 0 to π (place and claim: in "
                     "the tooltip, and in the file).",
                     columns);
    for (size_t r = 0; r < sg_route_count(); r++) {
        html_row_begin(report->page, NULL);
        html_cell_code(report->page, sg_route_at(r)->id);
        for (size_t s = 0; s < SHARPNESSES; s++)
            write_cell(report->page, all, r, s);
        html_row_end(report->page);
    }
    html_table_end(report->page, "data/routes.csv");
}

/* For each route: the first sharpness at which it fails, and where its own claim is furthest from
 * the truth. */
static void write_failures(report *report, const outcome *all)
{
    static const char *const columns[] = {
        "route",  "what it is",     "#fails from λ",        "#at β",
        "#error", "#claimed there", "#evaluations a point", NULL};
    html_table_begin(report->page,
                     "Where each route first misses by more than 1e-3, going up in λ and, at that "
                     "λ, at its worst angle; and what the route itself claims there.",
                     columns);
    for (size_t r = 0; r < sg_route_count(); r++) {
        size_t where = 0;
        double worst = 0.0;
        for (size_t s = 0; s < SHARPNESSES && worst <= failed; s++)
            for (size_t a = 0; a < ANGLES; a++)
                if (relative(at(all, r, s, a)) > worst) {
                    worst = relative(at(all, r, s, a));
                    where = s * ANGLES + a;
                }
        double evaluations = 0.0;
        for (size_t i = 0; i < SHARPNESSES * ANGLES; i++)
            evaluations += (double)at(all, r, i / ANGLES, i % ANGLES)->result.evaluations;
        html_row_begin(report->page, NULL);
        html_cell_code(report->page, sg_route_at(r)->id);
        html_cell_wrap(report->page, sg_route_at(r)->title);
        if (worst > failed) {
            const outcome *o = at(all, r, where / ANGLES, where % ANGLES);
            html_cell_number(report->page, sharpness[where / ANGLES], 1);
            html_cell_number(report->page, angle[where % ANGLES], 3);
            html_cell_marked(report->page, worst, 2, "bad", NULL);
            html_cell_number(report->page, claimed(o), 1);
        } else
            for (int i = 0; i < 4; i++)
                html_cell(report->page, i ? "" : "nowhere here");
        html_cell_number(report->page, evaluations / (SHARPNESSES * ANGLES), 3);
        html_row_end(report->page);
    }
    html_table_end(report->page, "data/routes.csv");
}

/* The points at which the routes fail in ways of their own. */
static void write_points(report *report, const outcome *all)
{
    static const size_t points[][2] = {{4, 5}, {4, 7}, {6, 4}, {8, 2}}; /* (1e2, 2.2) ... */
    static const char *const columns[] = {"route",           "#λ",       "#β", "#value", "#truth",
                                          "#relative error", "#claimed", NULL};
    html_table_begin(
        report->page,
        "The same at four points: behind the horizon at middling sharpness, and at "
        "two sharp peaks that fall between nodes. A claim of 0 beside an error of 1 is "
        "a peak that was never seen.",
        columns);
    for (size_t p = 0; p < sizeof points / sizeof *points; p++)
        for (size_t r = 0; r < sg_route_count(); r++) {
            const outcome *o = at(all, r, points[p][0], points[p][1]);
            double error = relative(o);
            html_row_begin(report->page, r ? NULL : "group");
            html_cell_code(report->page, sg_route_at(r)->id);
            html_cell_number(report->page, sharpness[points[p][0]], 1);
            html_cell_number(report->page, angle[points[p][1]], 3);
            html_cell_number(report->page, o->result.value, 4);
            html_cell_number(report->page, o->truth, 4);
            html_cell_marked(report->page, error, 2, error > failed ? "bad" : "good", NULL);
            html_cell_number(report->page, claimed(o), 1);
            html_row_end(report->page);
        }
    html_table_end(report->page, "data/routes.csv");
}

bool report_routes(report *report)
{
    size_t count = sg_route_count() * SHARPNESSES * ANGLES;
    outcome *all = calloc(count + 1, sizeof *all);
    if (!all)
        return false;
    base_parallel(count, evaluate, all);
    html_paragraph(report->page,
                   "A_h by the textbook routes, each as a careful reader would write it from eq. "
                   "12, against the reference. Errors above 1e-3 are marked.");
    write_csv(report, all);
    write_overview(report, all);
    write_failures(report, all);
    write_points(report, all);
    free(all);
    return true;
}
