/* commands.c: what this room adds to the program. */
#include "bench.h"
#include "bench_command.h"
#include "choose.h"
#include "report.h"
#include "stability.h"

const base_command bench_commands[] = {
    {"report", "write the error report: HTML to read, CSV behind every plot", report_command},
    {"bench", "measure what every method costs: GPU instructions, CPU, Vulkan device",
     bench_command},
    {"stability", "find where every method fails", stability_command},
    {"choose", "name the cheapest method that is good enough", choose_command},
    {NULL, NULL, NULL},
};
