#include "options.h"

#include "text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { HELP_WIDTH = 98, HELP_COLUMN = 30 };

/* Where a line of the form "  NAME  what it is" goes on below itself: under what it is. */
static int hanging(const char *line)
{
    size_t name = strspn(line, " ");
    size_t end = name + strcspn(line + name, "\n");
    const char *gap = name > 0 ? strstr(line + name, "  ") : NULL;
    return gap && gap < line + end ? (int)(gap - line) + (int)strspn(gap, " ") : 0;
}

/* Text from a column on, its own line ends kept, longer lines broken at blanks. */
static void print_wrapped(const char *text, int column)
{
    int hang = hanging(text), indent = 0;
    while (true) {
        int length = (int)strcspn(text, "\n");
        int part = length;
        if (length > HELP_WIDTH - column - indent) {
            part = HELP_WIDTH - column - indent;
            while (part > 0 && text[part] != ' ')
                part--;
            if (part == 0) /* one long word */
                part = (int)strcspn(text, " \n");
        }
        printf("%.*s\n", part, text);
        text += part;
        if (*text == '\0')
            return;
        if (*text++ == '\n') { /* else a blank */
            hang = hanging(text);
            indent = 0;
        } else {
            indent = hang;
        }
        printf("%*s", column + indent, "");
    }
}

static void print_help(const base_usage *usage, const base_option *options, size_t count)
{
    printf("usage: sgfit %s%s%s\n", usage->command, usage->synopsis && *usage->synopsis ? " " : "",
           usage->synopsis ? usage->synopsis : "");
    if (usage->text && *usage->text) {
        putchar('\n');
        print_wrapped(usage->text, 0);
    }
    printf("\noptions:\n");
    for (size_t i = 0; i < count; i++) {
        char left[128];
        int length = snprintf(left, sizeof left, "  --%s%s%s", options[i].name,
                              options[i].argument ? " " : "",
                              options[i].argument ? options[i].argument : "");
        if (length > HELP_COLUMN - 2)
            printf("%s\n%*s", left, HELP_COLUMN, "");
        else
            printf("%-*s", HELP_COLUMN, left);
        print_wrapped(options[i].help ? options[i].help : "", HELP_COLUMN);
    }
    printf("%-*s%s\n", HELP_COLUMN, "  --help", "prints this");
}

static bool is_choice(const char *choices, const char *value)
{
    size_t length = strlen(value);
    for (const char *p = choices; p; p = strchr(p, '|') ? strchr(p, '|') + 1 : NULL) {
        size_t end = strcspn(p, "|");
        if (end == length && strncmp(p, value, length) == 0)
            return true;
    }
    return false;
}

/* Stores the value; false after one line. */
static bool take_value(const char *command, const base_option *option, const char *value)
{
    double f64;
    switch (option->kind) {
    case BASE_FLAG:
        *(bool *)option->target = true;
        return true;
    case BASE_STRING:
        if (*value == '\0') {
            base_error("%s: --%s expects %s, found nothing", command, option->name,
                       option->argument ? option->argument : "a value");
            return false;
        }
        *(const char **)option->target = value;
        return true;
    case BASE_F64:
        if (!base_parse_f64(value, strlen(value), &f64) || isnan(f64)) {
            base_error("%s: --%s expects a number, found \"%s\"", command, option->name, value);
            return false;
        }
        *(double *)option->target = f64;
        return true;
    case BASE_LONG:
        if (!base_parse_long(value, option->target)) {
            base_error("%s: --%s expects a whole number, found \"%s\"", command, option->name,
                       value);
            return false;
        }
        return true;
    case BASE_CHOICE:
        if (!is_choice(option->argument, value)) {
            base_error("%s: --%s expects one of %s, found \"%s\"", command, option->name,
                       option->argument, value);
            return false;
        }
        *(const char **)option->target = value;
        return true;
    }
    return false;
}

static const base_option *find_option(const base_option *options, size_t count, const char *name,
                                      size_t length)
{
    for (size_t i = 0; i < count; i++)
        if (strlen(options[i].name) == length && strncmp(options[i].name, name, length) == 0)
            return &options[i];
    return NULL;
}

/* One option at argv[*i], whose value may be the argument after it. */
static bool take_option(int argc, char **argv, int *i, const char *command,
                        const base_option *options, size_t count, bool *seen)
{
    const char *name = argv[*i] + 2;
    size_t length = strcspn(name, "=");
    const base_option *option = find_option(options, count, name, length);
    if (argv[*i][1] != '-' || !option) {
        base_error("%s: unknown option \"%s\", expected one that sgfit %s --help lists", command,
                   argv[*i], command);
        return false;
    }
    const char *value = name[length] == '=' ? name + length + 1 : NULL;
    if (option->kind == BASE_FLAG && value) {
        base_error("%s: --%s takes no value, found \"%s\"", command, option->name, value);
        return false;
    }
    if (option->kind != BASE_FLAG && !value) {
        if (*i + 1 >= argc || strncmp(argv[*i + 1], "--", 2) == 0) {
            base_error("%s: --%s expects %s, found nothing", command, option->name,
                       option->argument ? option->argument : "a value");
            return false;
        }
        value = argv[++*i];
    }
    if (seen[option - options]) {
        base_error("%s: --%s is given twice, expected once", command, option->name);
        return false;
    }
    seen[option - options] = true;
    if (option->given)
        *option->given = true;
    return take_value(command, option, value);
}

int base_parse_options(int argc, char **argv, const base_usage *usage, const base_option *options,
                       size_t option_count, int *positional)
{
    bool *seen = calloc(option_count + 1, sizeof *seen);
    if (!seen)
        return BASE_FAILED;
    int found = 0, status = -1;
    bool only_positional = false;
    for (int i = 1; i < argc && status < 0; i++) {
        char *argument = argv[i];
        if (!only_positional && strcmp(argument, "--") == 0) {
            only_positional = true;
        } else if (!only_positional &&
                   (strcmp(argument, "--help") == 0 || strcmp(argument, "-h") == 0)) {
            print_help(usage, options, option_count);
            status = fflush(stdout) == 0 ? BASE_DONE : BASE_FAILED;
            if (status == BASE_FAILED)
                base_error("cannot write standard output");
        } else if (!only_positional && argument[0] == '-' && argument[1] != '\0') {
            if (!take_option(argc, argv, &i, usage->command, options, option_count, seen))
                status = BASE_USAGE;
        } else if (!positional) {
            base_error("%s: unexpected argument \"%s\" (sgfit %s --help lists what it takes)",
                       usage->command, argument, usage->command);
            status = BASE_USAGE;
        } else {
            argv[1 + found++] = argument;
        }
    }
    if (positional)
        *positional = found;
    free(seen);
    return status;
}
