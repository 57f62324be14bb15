/* bench_command.h: the command `sgfit bench`, for the list in bench.h. */
#ifndef BENCH_BENCH_COMMAND_H
#define BENCH_BENCH_COMMAND_H

int bench_command(int argc, char **argv);

#endif
