/* chart_bench.c: the page of `sgfit bench`: the chart, and what it was measured with. */
#include <stdio.h>
#include <stdlib.h>

#include "base/file.h"
#include "base/json.h"
#include "chart.h"
#include "html.h"
#include "page_css.h"

static void pairs(page *page, const cJSON *object)
{
    for (const cJSON *item = object ? object->child : NULL; item; item = item->next) {
        if (!cJSON_IsString(item) && !cJSON_IsNumber(item))
            continue;
        html_row_begin(page, NULL);
        html_cell(page, item->string);
        if (cJSON_IsString(item))
            html_cell_wrap(page, item->valuestring);
        else
            html_cell_number(page, item->valuedouble, 6);
        html_row_end(page);
    }
}

static void conditions(page *page, const cJSON *root)
{
    static const char *const keys[][2] = {{"machine", "Machine and versions"},
                                          {"gpu", "Instructions: counted by"},
                                          {"device", "Device ratio: measured on"},
                                          {"cpu", "CPU: how it was timed"}};
    static const char *const none[] = {NULL};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        html_table_begin(page, keys[i][1], none);
        pairs(page, cJSON_GetObjectItemCaseSensitive(root, keys[i][0]));
        html_table_end(page, NULL);
    }
    fputs("<p class=\"source\">All that was measured: <a href=\"cost.csv\">cost.csv</a> · "
          "<a href=\"cost.json\">cost.json</a></p>\n",
          page_html(page));
}

bool chart_bench_page(const char *folder)
{
    char *csv = base_join(folder, "cost.csv"), *json = base_join(folder, "cost.json");
    chart chart = {0};
    cJSON *root = base_json_read(json);
    bool done = root && chart_read_costs(&chart, csv, CHART_MAX, true);
    page *page = page_new("Clamped cosine and spherical Gaussians: speed against accuracy",
                          "What every method costs, on a GPU, on this CPU and on the Vulkan device "
                          "at hand, and how far it is from the exact integral.");
    page_style(page, (const char *)page_css, sizeof page_css);
    if (done) {
        page_section(page, "cost", "Speed against accuracy");
        done = chart_figure_write(page, &chart);
    }
    if (done) {
        page_section(page, "machine", "How it was measured");
        conditions(page, root);
    }
    done = done && page_write(page, folder, "index.html");
    page_free(page);
    cJSON_Delete(root);
    chart_free(&chart);
    free(csv);
    free(json);
    return done;
}
