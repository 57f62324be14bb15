/* report_machine.c: what the figures were computed with: machine, compiler, libraries; and the
 * speed of the reference, single and in batches. */
#define _POSIX_C_SOURCE 200809L
#include <gnu/libc-version.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#include "html.h"
#include "machine.h"
#include "report.h"
#include "report_speed.h"

static void row(page *page, const char *what, const char *value)
{
    html_row_begin(page, NULL);
    html_cell(page, what);
    html_cell(page, value && *value ? value : "not known");
    html_row_end(page);
}

/* The first line that a program of the machine prints of its own version; "" without it. */
static void version_of(const char *command, char *text, size_t size)
{
    text[0] = '\0';
    FILE *pipe = popen(command, "r");
    if (!pipe)
        return;
    if (fgets(text, (int)size, pipe))
        text[strcspn(text, "\n")] = '\0';
    pclose(pipe);
}

bool report_machine(report *report)
{
    static const char *const columns[] = {NULL};
    page *page = report->page;
    char text[256];
    struct utsname system = {0};
    uname(&system);
    html_table_begin(page, "Machine, compiler and libraries.", columns);
    machine_processor(text, sizeof text);
    row(page, "processor", text);
    snprintf(text, sizeof text, "%ld", sysconf(_SC_NPROCESSORS_ONLN));
    row(page, "cores in use", text);
    snprintf(text, sizeof text, "%s %s", system.sysname, system.machine);
    row(page, "system", text);
    row(page, "compiler", BENCH_COMPILER);
    row(page, "flags", BENCH_FLAGS);
    snprintf(text, sizeof text, "glibc %s", gnu_get_libc_version());
    row(page, "libm", text);
    row(page, "libsg", SG_VERSION);
    row(page, "Ceres", BENCH_CERES);
    row(page, "NLopt", BENCH_NLOPT);
    row(page, "OpenEXR", BENCH_OPENEXR);
    version_of("gnuplot --version 2>/dev/null", text, sizeof text);
    row(page, "gnuplot", text);
    report_driver(text, sizeof text);
    row(page, "Vulkan driver", text);
    html_table_end(page, NULL);

    char number[4][HTML_NUMBER_SIZE];
    report_speeds speeds = report_speed();
    html_paragraph(page,
                   "The reference on one core: %s evaluations of A_h a second by single calls, %s "
                   "in batches of 4096 points: %s times as many (λ logarithmic on [1e-3, 1e4], β "
                   "uniform on [0, π]; best of several runs).",
                   html_number(speeds.single, 2, number[0]),
                   html_number(speeds.batch, 2, number[1]),
                   html_number(speeds.batch / speeds.single, 2, number[2]));
    return true;
}
