/* fit.h: what the room of fits gives the program: fit, methods and eval. */
#ifndef FIT_FIT_H
#define FIT_FIT_H

#include <stdbool.h>

#include "base/options.h"

extern const base_command fit_commands[];

/* sgfit fit: runs recipes and writes constants; with --profile it fits to a scene's lights. */
int fit_command(int argc, char **argv);

/* What `sgfit fit --profile` asks for. */
typedef struct fit_profile_request {
    const char *profile; /* CSV with columns lambda, cos_theta and weight */
    const char *out;     /* constants file to write, or NULL */
    const char *emit;    /* shader include to write, or NULL */
    double budget;       /* most instructions */
    double max_error;    /* that the fewest instructions are wanted for */
    bool budget_given, max_error_given;
    bool by_max; /* errors are largest errors, rather than RMSEs by the weights */
} fit_profile_request;

/* Does it and returns the exit status. It counts instructions, which another room does: the program
 * sets this; NULL where it has not. */
extern int (*fit_profile)(const fit_profile_request *request);

#endif
