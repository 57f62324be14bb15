/* report_cost.c: the section "Speed against accuracy". */
#include <stdlib.h>

#include "base/file.h"
#include "chart.h"
#include "html.h"
#include "report.h"

bool report_cost(report *report)
{
    chart chart;
    bool done = chart_committed(&chart);
    if (done && report->bench) {
        char *path = base_join(report->bench, "cost.csv");
        done = chart_read_costs(&chart, path, CHART_CPU, false);
        free(path);
    }
    if (done) {
        html_paragraph(
            report->page,
            "The error of L in float against what one evaluation costs. Instructions and cycles "
            "are those that Mesa's RADV compiles for navi21, without the shader around the "
            "function; of published methods as their authors ship them. They come with the "
            "source tree (`tables/cost.csv`) and are the same in every run. %s",
            report->bench ? "Times on the CPU and on the Vulkan device were measured by `sgfit "
                            "bench` on this machine."
                          : "For times on the CPU and on a Vulkan device run `sgfit bench --out "
                            "DIR` and give this command `--bench DIR`.");
        done = chart_figure_write(report->page, &chart);
    }
    chart_free(&chart);
    return done;
}
