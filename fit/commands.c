/* The commands of this room, for main.c. */
#include "fit/eval.h"
#include "fit/fit.h"

const base_command fit_commands[] = {
    {"methods", "lists the approximations in the registry", methods_command},
    {"eval", "evaluates the reference, a method or a quadrature route at points", eval_command},
    {"fit", "runs the recipes and writes the constants they find", fit_command},
    {0},
};
