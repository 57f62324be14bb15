/* report_float.c: what float does to each method: the ranges of sharpness over which its float
 * result is not finite, negative, or far from its own double. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/progress.h"
#include "base/text.h"
#include "html.h"
#include "report.h"

enum { PER_DECADE = 16, DECADES = 18, STEPS = PER_DECADE * DECADES + 1, ANGLES = 129, KINDS = 3 };

static const double pi = 3.14159265358979323846;
static const double lowest = 1e-10; /* times 10^DECADES is the highest */

static const char *const kind_names[KINDS] = {"not finite", "negative, where double is not",
                                              "off by more than 1e-3"};

/* For each kind the worst that is found at one sharpness; below zero where it does not occur. */
typedef struct finding {
    double amount[KINDS];
} finding;

static finding look(const sg_method *method, double lambda)
{
    finding f = {{-1.0, -1.0, -1.0}};
    float narrow = (float)lambda;
    for (int j = 0; j < ANGLES; j++) {
        float z = (float)cos(pi * j / (ANGLES - 1));
        double value = (double)method->L_f32(narrow, z);
        double twin = method->L_f64((double)narrow, (double)z);
        if (!isfinite(twin))
            continue;
        if (!isfinite(value)) {
            f.amount[0] = (double)INFINITY;
            continue;
        }
        if (value < -1e-6 && twin >= 0.0)
            f.amount[1] = fmax(f.amount[1], -value);
        if (fabs(value - twin) > 1e-3)
            f.amount[2] = fmax(f.amount[2], fabs(value - twin));
    }
    return f;
}

/* The sharpness between a (where the kind occurs or not) and b (the other) at which it changes. */
static double boundary(const sg_method *method, int kind, double a, double b)
{
    bool at_a = look(method, a).amount[kind] >= 0.0;
    for (int i = 0; i < 24; i++) {
        double middle = sqrt(a * b);
        if ((look(method, middle).amount[kind] >= 0.0) == at_a)
            a = middle;
        else
            b = middle;
    }
    return sqrt(a * b);
}

typedef struct range {
    int kind;
    double from, to, worst;
} range;
enum { RANGES_MAX = 12 };
typedef struct ranges {
    range found[RANGES_MAX];
    int count;
} ranges;

static double step(int i)
{
    return lowest * pow(10.0, (double)i / PER_DECADE);
}

/* Ranges of one kind that are less than two decades apart are told as one: a cancellation comes
 * and goes with every rounding. */
static void add_range(ranges *out, range found)
{
    range *last = out->count ? &out->found[out->count - 1] : NULL;
    if (last && last->kind == found.kind && found.from < 100.0 * last->to) {
        last->to = found.to;
        last->worst = fmax(last->worst, found.worst);
    } else if (out->count < RANGES_MAX)
        out->found[out->count++] = found;
}

static void scan(void *context, size_t index)
{
    const sg_method *method = sg_method_at(index);
    ranges *out = (ranges *)context + index;
    finding found[STEPS];
    for (int i = 0; i < STEPS; i++)
        found[i] = look(method, step(i));
    for (int kind = 0; kind < KINDS; kind++) {
        range open = {kind, -1.0, 0.0, 0.0};
        for (int i = 0; i <= STEPS; i++) {
            bool occurs = i < STEPS && found[i].amount[kind] >= 0.0;
            if (occurs && open.from < 0.0)
                open.from = i ? boundary(method, kind, step(i - 1), step(i)) : 0.0;
            if (occurs)
                open.worst = fmax(open.worst, found[i].amount[kind]);
            if (!occurs && open.from >= 0.0) {
                open.to =
                    i < STEPS ? boundary(method, kind, step(i - 1), step(i)) : (double)INFINITY;
                add_range(out, open);
                open = (range){kind, -1.0, 0.0, 0.0};
            }
        }
    }
}

static void write_range(page *page, FILE *csv, const sg_method *method, const range *r, bool first)
{
    char text[3][BASE_NUMBER_SIZE];
    fprintf(csv, "%s,%s,%s,%s,%s\n", method->id, kind_names[r->kind],
            base_shortest_f64(r->from, text[0]), base_shortest_f64(r->to, text[1]),
            base_shortest_f64(r->worst, text[2]));
    html_row_begin(page, first ? "group" : NULL);
    html_cell_code(page, first ? method->id : "");
    html_cell(page, first ? method->variant : "");
    html_cell(page, kind_names[r->kind]);
    if (r->from > 0.0)
        html_cell_number(page, r->from, 3);
    else
        html_cell_marked(page, 0.0, 1, NULL, "from the lowest sharpness scanned, 1e-10");
    html_cell_number(page, r->to, 3);
    html_cell_marked(page, r->worst, 2, "bad", r->kind == 0 ? "NaN or infinite" : NULL);
    html_row_end(page);
}

bool report_float(report *report)
{
    static const char *const columns[] = {
        "method", "variant", "float result is", "#from λ", "#to λ", "#worst", NULL};
    page *page = report->page;
    ranges *all = calloc(report->methods + 1, sizeof *all);
    if (!all)
        return false;
    base_parallel(report->methods, scan, all);
    html_paragraph(page,
                   "L in float, scanned over λ from 1e-10 to 1e8 (%d sharpnesses a decade, ends "
                   "refined by bisection) at %d angles, against double of the same formula: where "
                   "float is not a number or infinite, negative, or off by more than 1e-3. What "
                   "double loses as well is the model's own and is not counted here.",
                   PER_DECADE, ANGLES);
    FILE *csv = page_file_begin(page, "data/float_failures.csv");
    fputs("method,kind,lambda_from,lambda_to,worst\n", csv);
    html_table_begin(page, "Ranges over which float breaks a method.", columns);
    size_t clean = 0;
    for (size_t i = 0; i < report->methods; i++) {
        for (int r = 0; r < all[i].count; r++)
            write_range(page, csv, sg_method_at(i), &all[i].found[r], r == 0);
        clean += all[i].count == 0;
    }
    page_file_end(page);
    html_table_end(page, "data/float_failures.csv");
    FILE *out = page_html(page);
    fprintf(out, "<p>Clean over the whole range: %zu of %zu methods%s", clean, report->methods,
            clean ? ": " : ".");
    for (size_t i = 0, n = 0; i < report->methods; i++)
        if (all[i].count == 0)
            fprintf(out, "%s<code>%s</code>", n++ ? ", " : "", sg_method_at(i)->id);
    fputs("</p>\n", out);
    free(all);
    return true;
}
