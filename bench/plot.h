/* plot.h: figures drawn by gnuplot as SVG, inside the page and as files for print.
 *
 * Inside the page a plot takes its colours from the style sheet (classes c1, c2, ...), so that it
 * follows light and dark; its legend is HTML and wraps on a phone. The file for print, written
 * beside it as figures/ID.svg, has fixed colours and a legend of its own. */
#ifndef BENCH_PLOT_H
#define BENCH_PLOT_H

#include <stdbool.h>

#include "data.h"
#include "page.h"

/* Colours 1 to 10 tell things apart; 11 to 18 are a scale from low to high. */
enum { PLOT_INK = 10, PLOT_SCALE = 11, PLOT_SCALE_STEPS = 8 };

/* Points are drawn of every second row of a dense curve, marks of every row. */
typedef enum plot_style { PLOT_LINE, PLOT_DASHED, PLOT_DOTTED, PLOT_POINTS, PLOT_MARKS } plot_style;

typedef struct plot_series {
    const char *label; /* NULL: drawn, but left out of the legend */
    int y;             /* column of the data */
    int colour;
    plot_style style;
    double width; /* 0: 2 */
} plot_series;

typedef struct plot {
    const char *id;    /* file names and anchor; letters, digits and '_' */
    const char *title; /* what this panel is, a few words */
    const char *x_label, *y_label;
    int x; /* column of the data */
    bool x_log, y_log;
    double x_range[2], y_range[2]; /* both equal: automatic */
    const char *setup;             /* further gnuplot commands, or NULL */
    const data_table *data;
    const plot_series *series;
    size_t series_count;
} plot;

/* A figure: one or more panels, then the caption, to which links to the CSVs are added. */
void figure_begin(page *page, const char *id);
/* Draws a panel and adds data/ID.csv; false after one line (no gnuplot, or it failed). */
bool figure_panel(page *page, const plot *plot);
void figure_end(page *page, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
