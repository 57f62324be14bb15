/* workspace.h: a temporary folder, files in it, and other programs run there. */
#ifndef TESTS_WORKSPACE_H
#define TESTS_WORKSPACE_H

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct workspace {
    char folder[256];
    char path[1024]; /* the last that workspace_path made */
} workspace;

static inline void workspace_open(workspace *at)
{
    const char *parent = getenv("TMPDIR");
    snprintf(at->folder, sizeof at->folder, "%s/sgfit-test-XXXXXX", parent ? parent : "/tmp");
    if (!mkdtemp(at->folder)) {
        fprintf(stderr, "no temporary folder\n");
        abort();
    }
}

/* The path of name in the folder, valid until the next call. */
static inline const char *workspace_path(workspace *at, const char *name)
{
    snprintf(at->path, sizeof at->path, "%s/%s", at->folder, name);
    return at->path;
}

static inline void workspace_write(workspace *at, const char *name, const char *text)
{
    FILE *file = fopen(workspace_path(at, name), "wb");
    if (!file || fputs(text, file) < 0 || fclose(file) != 0) {
        fprintf(stderr, "cannot write %s\n", at->path);
        abort();
    }
}

/* A path in the folder, to be freed, with a file of that text where text is not NULL. */
static inline char *workspace_file(workspace *at, const char *name, const char *text)
{
    if (text)
        workspace_write(at, name, text);
    return strdup(workspace_path(at, name));
}

/* The whole file as text, NULL where there is none; free() it. */
static inline char *workspace_read_path(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return NULL;
    fseek(file, 0, SEEK_END);
    long length = ftell(file);
    rewind(file);
    char *text = malloc((size_t)length + 1);
    size_t got = fread(text, 1, (size_t)length, file);
    text[got] = '\0';
    if (size)
        *size = got;
    fclose(file);
    return text;
}

/* Runs a shell command; its exit status, or 128 + the signal. */
__attribute__((format(printf, 1, 2))) static inline int shell(const char *format, ...)
{
    char command[4096];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(command, sizeof command, format, arguments);
    va_end(arguments);
    if (length < 0 || (size_t)length >= sizeof command)
        return -1;
    fflush(NULL);
    int status = system(command);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

static inline void workspace_close(workspace *at)
{
    shell("rm -rf '%s'", at->folder);
}

#endif
