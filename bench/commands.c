/* commands.c: what this room adds to the program. */
#include "bench.h"
#include "report.h"

const base_command bench_commands[] = {
    {"report", "write the error report: HTML to read, CSV behind every plot", report_command},
    {NULL, NULL, NULL},
};
