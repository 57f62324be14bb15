/* fit.h: what the room of fits gives the program: fit, methods and eval. */
#ifndef FIT_FIT_H
#define FIT_FIT_H

#include "base/options.h"

extern const base_command fit_commands[];

/* sgfit fit: runs recipes and writes constants. */
int fit_command(int argc, char **argv);

#endif
