/* report_readme.c: `sgfit report --readme FILE`: the figures in README.md and the picture that it
 * shows. Of committed data alone: equal inputs, equal bytes. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"
#include "chart.h"
#include "html.h"
#include "report.h"

static const char begin[] = "<!-- figures:", end[] = "<!-- /figures -->";

static void number(FILE *out, double value, int digits)
{
    char text[HTML_NUMBER_SIZE];
    fprintf(out, " %s |", isnan(value) ? "–" : html_number(value, digits, text));
}

/* The cheapest first; what was not counted last. */
static bool before(const chart_point *a, const chart_point *b)
{
    double x = a->figure[CHART_INSTRUCTIONS], y = b->figure[CHART_INSTRUCTIONS];
    if (isnan(x) || isnan(y))
        return !isnan(x) && isnan(y);
    return x < y;
}

static void rows(FILE *out, const chart *chart, chart_kind kind, const char *whose)
{
    bool *done = calloc(chart->count + 1, sizeof *done);
    for (;;) {
        const chart_point *next = NULL;
        for (size_t i = 0; done && i < chart->count; i++) {
            const chart_point *p = &chart->points[i];
            if (p->kind == kind && !done[i] && (!next || before(p, next)))
                next = p;
        }
        if (!next)
            break;
        done[next - chart->points] = true;
        fprintf(out, "| `%s` | %s |", next->id, whose);
        number(out, next->figure[CHART_INSTRUCTIONS], 0); /* whole ones */
        number(out, next->figure[CHART_MAX], 3);
        number(out, next->figure[CHART_RMSE], 3);
        fputc('\n', out);
    }
    free(done);
}

static void block(FILE *out, const chart *chart)
{
    fputs("Errors of L = A_h/A in float32, sharpness 1e-3 to 1e4 and all angles; instructions that "
          "RADV\ncompiles for navi21 for one L, of published methods as their authors ship "
          "them.\n\n"
          "| method | | instructions | max error | RMSE |\n| --- | --- | ---: | ---: | ---: |\n",
          out);
    rows(out, chart, CHART_TIER, "ours");
    rows(out, chart, CHART_PUBLISHED, "published");
}

/* The text with what stands between the two lines replaced; malloc'ed, NULL after one line. */
static char *replaced(const char *path, const char *text, const chart *chart)
{
    const char *from = strstr(text, begin), *to = from ? strstr(from, end) : NULL;
    const char *line = from ? strchr(from, '\n') : NULL;
    if (!to || !line || line > to) {
        base_error("report: %s: expected the lines %s ... --> and %s", path, begin, end);
        return NULL;
    }
    char *result = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&result, &size);
    if (!out) {
        base_error("report: out of memory");
        return NULL;
    }
    fwrite(text, 1, (size_t)(line + 1 - text), out);
    block(out, chart);
    fputs(to, out);
    fclose(out);
    return result;
}

/* tables/out/NAME beside the file, where its links lead to; NULL after one line. */
static char *picture_path(const char *readme, const char *name)
{
    const char *slash = strrchr(readme, '/');
    char *folder = slash ? strndup(readme, (size_t)(slash - readme + 1)) : strdup(".");
    char *path = folder ? base_join(folder, "tables/out") : NULL;
    free(folder);
    char *file = path && base_make_directory(path) ? base_join(path, name) : NULL;
    free(path);
    return file;
}

/* The pictures that README.md shows, of those that `sgfit bench --scenes` wrote. */
static bool copy_pictures(const char *readme, const char *scenes)
{
    static const char *const names[] = {"box_exact.png", "box_hull.png", "box_hull_errors.png"};
    char *folder = base_join(scenes, "pictures");
    bool good = true;
    for (size_t i = 0; i < sizeof names / sizeof *names && good; i++) {
        char *from = base_join(folder, names[i]), *to = picture_path(readme, names[i]);
        size_t size = 0;
        char *bytes = to ? base_read_file(from, &size) : NULL;
        good = bytes && base_write_file(to, bytes, size);
        free(from);
        free(to);
        free(bytes);
    }
    free(folder);
    return good;
}

bool report_readme(const char *path, const char *scenes)
{
    chart chart;
    bool done = chart_committed(&chart);
    char *text = done ? base_read_file(path, NULL) : NULL;
    char *written = text ? replaced(path, text, &chart) : NULL;
    char *svg = written ? chart_svg(&chart, false) : NULL;
    char *picture = svg ? picture_path(path, "chart.svg") : NULL;
    done = picture && base_write_file(picture, svg, strlen(svg)) &&
           base_write_file(path, written, strlen(written)) &&
           (!scenes || copy_pictures(path, scenes));
    free(picture);
    free(svg);
    free(written);
    free(text);
    chart_free(&chart);
    return done;
}
