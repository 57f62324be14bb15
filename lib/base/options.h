/* options.h: command lines. One table a command: parsing, --help and diagnostics come from it. */
#ifndef BASE_OPTIONS_H
#define BASE_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

/* Exit statuses of every command. */
enum { BASE_DONE = 0, BASE_FAILED = 1, BASE_USAGE = 2 };

typedef enum base_option_kind {
    BASE_FLAG,   /* target: bool */
    BASE_STRING, /* target: const char * */
    BASE_F64,    /* target: double */
    BASE_LONG,   /* target: long */
    BASE_CHOICE  /* target: const char *, one of choices, "a|b|c" */
} base_option_kind;

typedef struct base_option {
    const char *name; /* "method", given as --method X or --method=X */
    base_option_kind kind;
    void *target;
    const char *argument; /* name of the argument in --help; for BASE_CHOICE the choices */
    const char *help;
    bool *given; /* may be NULL */
} base_option;

typedef struct base_usage {
    const char *command;  /* "eval" */
    const char *synopsis; /* "[options] [FILE]" */
    const char *text;     /* a paragraph for --help */
} base_usage;

/* Parses argv[1..]; positional arguments are moved to argv[1..*positional] (positional NULL: none
 * allowed). An option given twice, an empty value and NaN for a number are refused. Returns -1 to
 * go on, or the exit status: BASE_DONE after
 * --help was printed, BASE_USAGE after one line about what is wrong. */
int base_parse_options(int argc, char **argv, const base_usage *usage, const base_option *options,
                       size_t option_count, int *positional);

/* What a room exports. Ends with {NULL}. */
typedef struct base_command {
    const char *name;
    const char *summary;
    int (*run)(int argc, char **argv); /* argv[0] is the command's name */
} base_command;

#endif
