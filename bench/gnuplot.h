/* gnuplot.h: the child process that draws. */
#ifndef BENCH_GNUPLOT_H
#define BENCH_GNUPLOT_H

#include <stdbool.h>
#include <stddef.h>

/* Runs gnuplot on the script and returns what it writes to standard output, malloc'ed, with a NUL
 * at the end; NULL after one line that says what is missing or wrong. */
char *gnuplot_run(const char *script, size_t size);

/* Whether it can be run at all; false after the same line. */
bool gnuplot_there(void);

/* gnuplot's SVG made fit to stand inside a page as the element `id` (inside = true: colours from
 * the style sheet, no header, names made unique) or in a file of its own (fixed colours). label
 * is its description for readers who do not see it. Colours are recognised by the numbers that
 * plot.c draws with. malloc'ed. */
char *gnuplot_adapt(const char *svg, const char *id, const char *label, bool inside);

#endif
