/* scenes_command.h: `sgfit bench --scenes`, called by bench. */
#ifndef BENCH_SCENES_COMMAND_H
#define BENCH_SCENES_COMMAND_H

#include <stdbool.h>

/* folder: of the meshes, or "built-in"; only: names of views that begin so, NULL: all. The exit
 * status, after one line where it is not 0. */
int scenes_command(const char *folder, const char *only, const char *device, const char *out,
                   bool quick);

#endif
