/* scenes_command.h: `sgfit bench --scenes`, called by bench. */
#ifndef BENCH_SCENES_COMMAND_H
#define BENCH_SCENES_COMMAND_H

#include <stdbool.h>

/* The parts, in the order of their run; X(part) is called with each, whose work is the function
 * scenes_PART of scenes.h. */
/* clang-format off */
#define SCENES_PARTS(X) \
    X(views) X(steps) X(rates) X(paper) X(growth) X(flicker) \
    X(shadows) X(area_refinement) X(area_flicker) X(indirect) X(lobes) X(choice)
/* clang-format on */

/* Only where they are asked for by name. */
#define SCENES_EXTRA_PARTS(X) X(tune)

typedef struct scenes_request {
    const char *folder; /* of the meshes, or "built-in" */
    const char *only;   /* names of views that begin so; NULL: all */
    const char *parts;  /* names with commas between; NULL: all */
    const char *device; /* part of its name */
    const char *out;
    bool quick;
} scenes_request;

/* The exit status, after one line where it is not 0. */
int scenes_command(const scenes_request *request);

#endif
