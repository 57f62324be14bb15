/* bench.h: measuring: accuracy, speed, cost, and the pages that show them. */
#ifndef BENCH_BENCH_H
#define BENCH_BENCH_H

#include "base/options.h"

extern const base_command bench_commands[];

#endif
