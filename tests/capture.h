/* capture.h: what a function under test prints on standard error. */
#ifndef TESTS_CAPTURE_H
#define TESTS_CAPTURE_H

#include <stdio.h>
#include <string.h>
#include <unistd.h>

typedef struct capture {
    FILE *file;
    int saved;
    char text[4096];
} capture;

static inline void capture_begin(capture *c)
{
    fflush(stderr);
    c->file = tmpfile();
    c->saved = dup(STDERR_FILENO);
    dup2(fileno(c->file), STDERR_FILENO);
}

/* Returns what was printed since. */
static inline const char *capture_end(capture *c)
{
    fflush(stderr);
    dup2(c->saved, STDERR_FILENO);
    close(c->saved);
    rewind(c->file);
    c->text[fread(c->text, 1, sizeof c->text - 1, c->file)] = '\0';
    fclose(c->file);
    return c->text;
}

/* Whether text is one line of the program's form that holds every one of the NULL-ended words. */
static inline int is_one_line(const char *text, const char *const *words)
{
    const char *end = strchr(text, '\n');
    int good = strncmp(text, "sgfit: ", 7) == 0 && end && end[1] == '\0';
    for (; good && *words; words++)
        good = strstr(text, *words) != NULL;
    if (!good)
        fprintf(stderr, "expected one line with all the words, found: %s\n", text);
    return good;
}

#define assert_one_line(text, ...)                                                                 \
    assert_true(is_one_line(text, (const char *const[]){__VA_ARGS__, NULL}))

#endif
