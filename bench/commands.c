/* commands.c: what this room adds to the program. */
#include "bench.h"
#include "bench_command.h"
#include "choose.h"
#include "report.h"
#include "stability.h"

const base_command bench_commands[] = {
    {"report", "writes the error report: HTML to read, CSV behind every plot", report_command},
    {"bench", "measures what every method costs: GPU instructions, CPU, Vulkan device",
     bench_command},
    {"stability", "finds where every method fails", stability_command},
    {"choose", "names the cheapest method that is good enough", choose_command},
    {NULL, NULL, NULL},
};
