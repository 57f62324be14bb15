/* chart_page.c: the chart in a page: its figures as JSON, the library, and the SVG beneath. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/json.h"
#include "base/text.h"
#include "chart.h"
#include "chart_css.h"
#include "chart_js.h"
#include "chart_library.h"
#include "html.h"

static const char *const kind_ids[CHART_KINDS] = {"published", "stable", "refit", "tier", "table"};

static const char *const figure_names[CHART_FIGURES] = {
    "largest error of L, float",
    "RMSE of L, float",
    "GPU instructions (navi21)",
    "GPU cycles of one more evaluation (navi21, slope)",
    "CPU, ns an evaluation, batch of floats",
    "Vulkan device, ratio to an addition",
};

/* The text of a script element ends at "</", wherever that stands: "<" is written otherwise. */
static void put_json(FILE *out, const cJSON *root)
{
    char *text = base_json_print(root);
    fputs("<script type=\"application/json\" id=\"chart-data\">\n", out);
    for (const char *c = text; c && *c; c++)
        if (*c == '<')
            fputs("\\u003c", out);
        else
            fputc(*c, out);
    fputs("</script>\n", out);
    free(text);
}

static void add_figure(cJSON *object, const char *name, double value)
{
    if (isnan(value))
        cJSON_AddNullToObject(object, name);
    else
        base_json_add_f64(object, name, value);
}

static void write_data(page *page, const chart *chart)
{
    cJSON *root = cJSON_CreateObject();
    cJSON *figures = cJSON_AddObjectToObject(root, "figures");
    for (int f = 0; f < CHART_FIGURES; f++)
        cJSON_AddStringToObject(figures, chart_columns[f], figure_names[f]);
    cJSON *kinds = cJSON_AddArrayToObject(root, "kinds");
    for (int k = 0; k < CHART_KINDS; k++) {
        cJSON *kind = cJSON_CreateObject();
        cJSON_AddStringToObject(kind, "id", kind_ids[k]);
        cJSON_AddStringToObject(kind, "name", chart_looks[k].name);
        cJSON_AddStringToObject(kind, "shape", chart_looks[k].shape);
        cJSON_AddNumberToObject(kind, "colour", chart_looks[k].colour);
        cJSON_AddItemToArray(kinds, kind);
    }
    cJSON *points = cJSON_AddArrayToObject(root, "points");
    for (size_t i = 0; i < chart->count; i++) {
        const chart_point *p = &chart->points[i];
        cJSON *point = cJSON_CreateObject();
        cJSON_AddStringToObject(point, "method", p->id);
        cJSON_AddStringToObject(point, "kind", kind_ids[p->kind]);
        cJSON_AddBoolToObject(point, "whole", p->lambda_min <= 1e-3);
        base_json_add_f64(point, "lambda_min", p->lambda_min);
        base_json_add_f64(point, "fetches", p->fetches);
        for (int f = 0; f < CHART_FIGURES; f++)
            add_figure(point, chart_columns[f], p->figure[f]);
        cJSON_AddItemToArray(points, point);
    }
    put_json(page_html(page), root);
    cJSON_Delete(root);
}

static void write_select(FILE *out, const char *id, const char *label, int from, int to)
{
    fprintf(out, "<label>%s <select id=\"%s\">\n", label, id);
    for (int f = from; f < to; f++)
        fprintf(out, "<option value=\"%s\">%s</option>\n", chart_columns[f], figure_names[f]);
    fputs("</select></label>\n", out);
}

static void write_legend(FILE *out)
{
    fputs("<ul class=\"legend\">\n", out);
    for (int k = 0; k < CHART_KINDS; k++)
        fprintf(out, "<li><span class=\"c%d\" aria-hidden=\"true\">%s</span>%s</li>\n",
                chart_looks[k].colour, chart_looks[k].sign, chart_looks[k].name);
    fputs("<li><span aria-hidden=\"true\">┄┄</span>front: nothing here is both cheaper and more "
          "accurate</li>\n</ul>\n",
          out);
}

static void cell(page *page, double value)
{
    if (isnan(value))
        fputs("<td class=\"n\">–</td>", page_html(page));
    else
        html_cell_marked(page, value, 3, isfinite(value) ? NULL : "bad", NULL);
}

static void write_table(page *page, const chart *chart)
{
    static const char *const columns[] = {"method",
                                          "",
                                          "#max |error|",
                                          "#RMSE",
                                          "#GPU instructions",
                                          "#GPU slope, cycles",
                                          "#CPU, ns",
                                          "#device, ratio",
                                          NULL};
    FILE *csv = page_file_begin(page, "data/chart.csv");
    fputs("method,kind", csv);
    for (int f = 0; f < CHART_FIGURES; f++)
        fprintf(csv, ",%s", chart_columns[f]);
    fputs("\n", csv);
    html_table_begin(page, "The figures behind the chart.", columns);
    for (size_t i = 0; i < chart->count; i++) {
        const chart_point *p = &chart->points[i];
        char text[BASE_NUMBER_SIZE];
        fprintf(csv, "%s,%s", p->id, kind_ids[p->kind]);
        html_row_begin(page, NULL);
        html_cell_code(page, p->id);
        html_cell(page, kind_ids[p->kind]);
        for (int f = 0; f < CHART_FIGURES; f++) {
            cell(page, p->figure[f]);
            fprintf(csv, ",%s", isnan(p->figure[f]) ? "" : base_shortest_f64(p->figure[f], text));
        }
        fputs("\n", csv);
        html_row_end(page);
    }
    page_file_end(page);
    html_table_end(page, "data/chart.csv");
}

static void write_scripts(page *page)
{
    page_style(page, (const char *)chart_css, sizeof chart_css);
    if (sizeof chart_library > 1) {
        page_script(page, (const char *)chart_library, sizeof chart_library);
        page_script(page, "\n", 1);
        page_script(page, (const char *)chart_js, sizeof chart_js);
    }
}

bool chart_figure_write(page *page, const chart *chart)
{
    char *inside = chart_svg(chart, true), *file = inside ? chart_svg(chart, false) : NULL;
    if (!file) {
        free(inside);
        return false;
    }
    FILE *out = page_html(page);
    fputs("<figure id=\"chart\" class=\"chart\">\n<div class=\"controls\">\n", out);
    write_select(out, "chart-error", "Error", 0, CHART_FIRST_COST);
    write_select(out, "chart-cost", "Cost", CHART_FIRST_COST, CHART_FIGURES);
    fputs("</div>\n<div class=\"canvas\"><canvas id=\"chart-canvas\" role=\"img\" "
          "aria-label=\"Error against cost of every method; the table below has the same "
          "figures\"></canvas></div>\n<div class=\"plain\">\n",
          out);
    fputs(inside, out);
    fputs("</div>\n", out);
    write_legend(out);
    fputs("<p class=\"source\" id=\"chart-left\"></p>\n<figcaption>", out);
    html_text(out, "Both axes are logarithmic. An error that is infinite stands on the upper edge. "
                   "A method that is not defined on the whole grid is no part of the front, nor is "
                   "a table where instructions are counted, because a fetch costs more than its "
                   "instruction. ");
    html_text(out, sizeof chart_library > 1
                       ? "Hover over a point, or tap it, for its figures. Drawn by Chart.js."
                       : "This program was built without Chart.js, so the chart does not answer to "
                         "the pointer: install the package libjs-chart.js and build again.");
    fputs("</figcaption>\n<p class=\"source\"><a href=\"data/chart.csv\">data/chart.csv</a> · "
          "<a href=\"figures/chart.svg\">SVG for print</a></p>\n</figure>\n",
          out);
    page_file(page, "figures/chart.svg", file, strlen(file));
    write_data(page, chart);
    write_scripts(page);
    write_table(page, chart);
    free(inside);
    free(file);
    return true;
}
