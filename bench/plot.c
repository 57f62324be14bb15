/* plot.c: see plot.h. */
#define _POSIX_C_SOURCE 200809L
#include "plot.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "gnuplot.h"
#include "html.h"

static void quoted(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"' || *text == '\\')
            fputc('\\', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

static void axis(FILE *out, char name, const char *label, bool logarithmic, const double range[2])
{
    fprintf(out, "set %clabel ", name);
    quoted(out, label);
    fputs(" noenhanced\n", out);
    if (logarithmic)
        fprintf(out, "set logscale %c\nset format %c \"10^{%%T}\"\n", name, name);
    if (range[0] < range[1] || range[0] > range[1])
        fprintf(out, "set %crange [%.17g:%.17g]\n", name, range[0], range[1]);
}

static void numbers(FILE *out, const data_table *data)
{
    char text[BASE_NUMBER_SIZE];
    fputs("$data << END\n", out);
    for (size_t r = 0; r < data->rows; r++)
        for (size_t c = 0; c < data->columns; c++) {
            double value = data_at(data, r, c);
            fprintf(out, "%s%s", isfinite(value) ? base_shortest_f64(value, text) : "NaN",
                    c + 1 < data->columns ? "," : "\n");
        }
    fputs("END\n", out);
}

static void series(FILE *out, const plot *plot, const plot_series *s)
{
    static const char *const dashes[] = {"", " dt (7,4)", " dt (2,3)", "", ""};
    double width = s->width > 0.0 ? s->width : 2.0;
    /* of points every second one: they stand for a curve and need not touch */
    fprintf(out, "$data%s using %d:%d with %s lc rgb \"#%06x\" lw %g%s",
            s->style == PLOT_POINTS ? " every 2" : "", plot->x + 1, s->y + 1,
            s->style == PLOT_MARKS    ? "points pt 7 ps 0.7"
            : s->style == PLOT_POINTS ? "points pt 7 ps 0.45"
                                      : "lines",
            (unsigned)s->colour, width, dashes[s->style]);
    if (s->label) {
        fputs(" title ", out);
        quoted(out, s->label);
    } else
        fputs(" notitle", out);
}

static char *draw(const plot *plot, bool key)
{
    char *script = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&script, &size);
    if (!out)
        return NULL;
    size_t legend = key ? 18 * plot->series_count + 14 : 0;
    fprintf(out,
            "set encoding utf8\n"
            "set terminal svg size 480,%zu dynamic enhanced name \"%s\" "
            "font \"system-ui,sans-serif,14\"\n"
            "set datafile separator ','\nset border 3 lw 0.8\nset tics nomirror out scale 0.6\n"
            "set grid lw 0.6 dt 1 lc rgb \"gray\"\n",
            (size_t)330 + legend, plot->id);
    fputs(key ? "set key outside below vertical Left reverse maxcols 1 samplen 2 noenhanced font "
                "\",12\"\n"
              : "unset key\n",
          out);
    if (key) {
        fputs("set title ", out);
        quoted(out, plot->title);
        fputs(" noenhanced\n", out);
    }
    axis(out, 'x', plot->x_label, plot->x_log, plot->x_range);
    axis(out, 'y', plot->y_label, plot->y_log, plot->y_range);
    if (plot->setup)
        fprintf(out, "%s\n", plot->setup);
    numbers(out, plot->data);
    for (size_t i = 0; i < plot->series_count; i++) {
        fputs(i ? ", " : "plot ", out);
        series(out, plot, &plot->series[i]);
    }
    fputs("\n", out);
    fclose(out);
    char *svg = gnuplot_run(script, size);
    free(script);
    char *adapted = svg ? gnuplot_adapt(svg, plot->id, plot->title, !key) : NULL;
    free(svg);
    return adapted;
}

static void legend(page *page, const plot *plot)
{
    static const char *const kinds[] = {"line", "dashed", "dotted", "points"};
    FILE *out = page_html(page);
    fputs("<ul class=\"legend\">\n", out);
    for (size_t i = 0; i < plot->series_count; i++) {
        const plot_series *s = &plot->series[i];
        if (!s->label)
            continue;
        fprintf(out, "<li><span class=\"swatch c%d %s\"></span>", s->colour, kinds[s->style]);
        html_text(out, s->label);
        fputs("</li>\n", out);
    }
    fputs("</ul>\n", out);
}

void figure_begin(page *page, const char *id)
{
    fprintf(page_html(page), "<figure id=\"%s\">\n<div class=\"panels\">\n", id);
}

static void add_files(page *page, const plot *plot, const char *svg)
{
    char name[160];
    snprintf(name, sizeof name, "data/%s.csv", plot->id);
    data_csv(plot->data, page_file_begin(page, name));
    page_file_end(page);
    snprintf(name, sizeof name, "figures/%s.svg", plot->id);
    page_file(page, name, svg, strlen(svg));
}

bool figure_panel(page *page, const plot *plot)
{
    char *inside = draw(plot, false);
    char *file = inside ? draw(plot, true) : NULL;
    if (file) {
        FILE *out = page_html(page);
        fputs("<div class=\"panel\">\n<h3>", out);
        html_text(out, plot->title);
        fputs("</h3>\n", out);
        fputs(inside, out);
        legend(page, plot);
        fprintf(out,
                "<p class=\"source\"><a href=\"data/%s.csv\">data/%s.csv</a> · "
                "<a href=\"figures/%s.svg\">SVG for print</a></p>\n</div>\n",
                plot->id, plot->id, plot->id);
        add_files(page, plot, file);
    }
    bool done = file != NULL;
    free(inside);
    free(file);
    return done;
}

void figure_end(page *page, const char *format, ...)
{
    FILE *out = page_html(page);
    va_list arguments;
    va_start(arguments, format);
    fputs("</div>\n<figcaption>", out);
    html_formatted(out, format, arguments);
    fputs("</figcaption>\n</figure>\n", out);
    va_end(arguments);
}
