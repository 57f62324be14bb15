/* gnuplot.c: see gnuplot.h. */
#define _POSIX_C_SOURCE 200809L
#include "gnuplot.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/text.h"
#include "html.h"
#include "plot.h"

extern char **environ;

/* The script goes in through a file and not a pipe, so that neither side waits for the other. */
static FILE *script_file(const char *script, size_t size)
{
    FILE *file = tmpfile();
    if (!file)
        return NULL;
    if (fwrite(script, 1, size, file) != size || fflush(file) != 0 || fseek(file, 0, SEEK_SET)) {
        fclose(file);
        return NULL;
    }
    return file;
}

static pid_t start(FILE *input, int output[2], int *error)
{
    static char name[] = "gnuplot";
    char *arguments[] = {name, NULL};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, fileno(input), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, output[0]);
    /* its complaints take several lines; that the drawing is missing is told in one */
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = -1;
    *error = posix_spawnp(&child, name, &actions, NULL, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    return *error ? -1 : child;
}

static char *read_all(int descriptor)
{
    char *text = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&text, &size);
    if (!memory)
        return NULL;
    char buffer[8192];
    ssize_t count;
    while ((count = read(descriptor, buffer, sizeof buffer)) > 0 || (count < 0 && errno == EINTR))
        if (count > 0)
            fwrite(buffer, 1, (size_t)count, memory);
    fclose(memory);
    return text;
}

char *gnuplot_run(const char *script, size_t size)
{
    FILE *input = script_file(script, size);
    int output[2];
    if (!input || pipe(output) != 0) {
        base_error("report: cannot hand a plot to gnuplot: %s", strerror(errno));
        if (input)
            fclose(input);
        return NULL;
    }
    int error;
    pid_t child = start(input, output, &error);
    close(output[1]);
    fclose(input);
    char *svg = child > 0 ? read_all(output[0]) : NULL;
    close(output[0]);
    if (child < 0) {
        base_error("report: gnuplot draws the figures and cannot be started (%s): install the "
                   "package gnuplot-nox",
                   strerror(error));
        return NULL;
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !svg || !strstr(svg, "</svg>")) {
        base_error("report: gnuplot ended without drawing the figure (status %d)",
                   WIFEXITED(status) ? WEXITSTATUS(status) : -1);
        free(svg);
        return NULL;
    }
    return svg;
}

bool gnuplot_there(void)
{
    static const char smallest[] = "set terminal svg\nplot x\n";
    char *svg = gnuplot_run(smallest, sizeof smallest - 1);
    free(svg);
    return svg != NULL;
}

/* ---- Adapting ------------------------------------------------------------------------------ */

/* Light colours, for the file; those of the page stand in page.css. */
static const char *const fixed_colours[] = {"#000000", "#0068b5", "#c43c00", "#00805a", "#a0408c",
                                            "#7a6a00", "#5a52c8", "#0088a8", "#b5305a", "#5f6f1f",
                                            "#1a1a1a", "#2b5fc4", "#1b7fb0", "#14907f", "#4f9a3a",
                                            "#93901c", "#c07a12", "#cf5a2a", "#c43a4a"};

static bool starts(const char *text, const char *prefix)
{
    return strncmp(text, prefix, strlen(prefix)) == 0;
}

/* `stroke='rgb(  0,   0,   3)'` and the same with color: returns its length, 0 if it is not. */
static int colour_at(const char *at, bool *stroke, int *colour)
{
    int length = 0;
    *stroke = false;
    if (!starts(at, "stroke='rgb(") && !starts(at, "color='rgb("))
        return 0; /* sscanf looks at all the rest of the text: not at every character */
    if (sscanf(at, "stroke='rgb( 0, 0, %d)'%n", colour, &length) == 1 && length)
        *stroke = true;
    else if (sscanf(at, "color='rgb( 0, 0, %d)'%n", colour, &length) != 1)
        return 0;
    int known = (int)(sizeof fixed_colours / sizeof *fixed_colours);
    return length && *colour >= 1 && *colour < known ? length : 0;
}

static void copy_body(FILE *out, const char *at, const char *id, bool inside)
{
    static const char *const inks[][2] = {{"stroke='black'", "stroke='currentColor'"},
                                          {"stroke=\"black\"", "stroke=\"currentColor\""},
                                          {"fill=\"black\"", "fill=\"currentColor\""},
                                          {"color=\"black\"", "color=\"inherit\""}};
    while (*at) {
        bool stroke;
        int colour, length = colour_at(at, &stroke, &colour);
        if (length) {
            if (inside)
                fprintf(out, "class=\"c%d\"", colour);
            else
                fprintf(out, "%s=\"%s\"", stroke ? "stroke" : "color", fixed_colours[colour]);
            at += length;
            continue;
        }
        if (starts(at, "id='gp") || starts(at, "'#gp")) {
            int skip = *at == 'i' ? 4 : 2;
            fprintf(out, "%.*s%s_", skip, at, id);
            at += skip;
            continue;
        }
        size_t i = 0, count = inside ? sizeof inks / sizeof *inks : 0;
        while (i < count && !starts(at, inks[i][0]))
            i++;
        if (i < count) {
            fputs(inks[i][1], out);
            at += strlen(inks[i][0]);
        } else
            fputc(*at++, out);
    }
}

char *gnuplot_adapt(const char *svg, const char *id, const char *label, bool inside)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    const char *tag = strstr(svg, "<svg"), *box = strstr(svg, "viewBox=\"");
    const char *defs = strstr(svg, "<defs>"), *filters = strstr(svg, "<filter");
    const char *after = strstr(svg, "</defs>");
    if (!out || !tag || !box || !defs || !after) {
        base_error("report: this gnuplot's SVG is not understood (5.4 is)");
        if (out)
            fclose(out);
        free(text);
        return NULL;
    }
    if (!inside)
        fputs("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n", out);
    fprintf(out, "<svg class=\"plot\" role=\"img\" %.*s\"", (int)strcspn(box + 9, "\"") + 9, box);
    if (!inside)
        fputs(" xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"",
              out);
    fputs(">\n<title>", out);
    for (const char *c = label; *c; c++)
        fputs(*c == '<' ? "&lt;" : *c == '&' ? "&amp;" : (char[]){*c, '\0'}, out);
    fputs("</title>\n<g>\n", out);
    if (!inside)
        fputs("<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n", out);
    char *symbols = strndup(defs, (size_t)((filters && filters < after ? filters : after) - defs));
    if (symbols)
        copy_body(out, symbols, id, inside);
    free(symbols);
    copy_body(out, after, id, inside);
    fclose(out);
    return text;
}
