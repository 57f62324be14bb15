/* chart.h: error against cost: every method a point, as an interactive figure in a page and as a
 * plain SVG. Private to bench.
 *
 * The figure of the page is drawn by Chart.js, which is part of the page where CMake found it; the
 * SVG stands in its place in print, without scripts and without that library. */
#ifndef BENCH_CHART_H
#define BENCH_CHART_H

#include <stdbool.h>
#include <stddef.h>

#include "page.h"

typedef enum chart_figure {
    CHART_MAX, /* errors of L in float */
    CHART_RMSE,
    CHART_INSTRUCTIONS, /* of one evaluation on a GPU (navi21), */
    CHART_SLOPE,        /* and the compiler's cycles of one more */
    CHART_CPU,          /* nanoseconds, floats, batch call */
    CHART_DEVICE,       /* ratio to an addition on the Vulkan device at hand */
    CHART_FIGURES
} chart_figure;

enum { CHART_FIRST_COST = CHART_INSTRUCTIONS };

typedef enum chart_kind {
    CHART_PUBLISHED,
    CHART_STABLE,
    CHART_REFIT,
    CHART_TIER,
    CHART_TABLE, /* a look-up table, not a method of the registry */
    CHART_KINDS
} chart_kind;

typedef struct chart_look {
    const char *name;  /* in the legend */
    int colour;        /* class cN of page.css */
    const char *shape; /* of Chart.js */
    const char *sign;  /* the same shape as a character */
    int gnuplot;       /* and as gnuplot's point type */
} chart_look;

extern const chart_look chart_looks[CHART_KINDS];

typedef struct chart_point {
    char id[64];
    chart_kind kind;
    double lambda_min; /* measured from this sharpness; above the grid's least: not on the front */
    double fetches;    /* of a texture */
    double figure[CHART_FIGURES]; /* NaN: not measured */
} chart_point;

typedef struct chart {
    chart_point *points;
    size_t count;
} chart;

/* ---- chart_data.c ---------------------------------------------------------------------------- */

extern const char *const chart_columns[CHART_FIGURES]; /* of cost.csv */

/* All methods of the registry, nothing measured. */
void chart_registry(chart *chart);
/* Figures from first on out of a cost.csv. new_rows: methods and tables that are not there yet are
 * added. Columns that the file lacks stay unmeasured. False after one line. */
bool chart_read_costs(chart *chart, const char *path, chart_figure first, bool new_rows);
/* The errors that stand in tables/constants. False after one line. */
bool chart_read_errors(chart *chart);
/* The last three with what is committed: equal inputs, equal figures. */
bool chart_committed(chart *chart);
void chart_free(chart *chart);

/* Whether the point may stand on the front for that cost: defined on the whole grid, and with all
 * of its cost in the figure (a fetch is no instruction). */
bool chart_competes(const chart_point *point, chart_figure cost);
/* Indices of the points that no other one beats in both, by rising cost; front has room for all.
 * Returns how many. */
size_t chart_front(const chart *chart, chart_figure error, chart_figure cost, size_t *front);

/* ---- chart_svg.c ----------------------------------------------------------------------------- */

/* Maximum error against instructions. inside: for a page (gnuplot.h); else a file. malloc'ed; NULL
 * after one line. */
char *chart_svg(const chart *chart, bool inside);

/* ---- chart_page.c ---------------------------------------------------------------------------- */

/* The figure, data/cost.csv-like table below it, figures/chart.svg. False after one line. */
bool chart_figure_write(page *page, const chart *chart);

/* ---- chart_bench.c: the page of `sgfit bench` ------------------------------------------------ */

/* DIR/index.html from DIR/cost.csv and DIR/cost.json. False after one line. */
bool chart_bench_page(const char *folder);

#endif
