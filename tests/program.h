/* program.h: runs the program as users do: arguments and standard input in, both outputs and the
 * exit status out. The program's path is in the environment as SGFIT. */
#ifndef TESTS_PROGRAM_H
#define TESTS_PROGRAM_H

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct run {
    int status; /* of exit, or 128 + the signal */
    char *out;  /* with a NUL behind out_size bytes */
    char *error;
    size_t out_size;
} run;

typedef struct run_options {
    const char *input;    /* standard input as text; NULL: empty */
    const char *in_path;  /* or from a file */
    const char *out_path; /* standard output to a file or device */
    size_t input_size;    /* 0: strlen(input) */
} run_options;

static inline char *program_read(FILE *file, size_t *size)
{
    fseek(file, 0, SEEK_END);
    long length = ftell(file);
    rewind(file);
    char *text = malloc((size_t)length + 1);
    *size = fread(text, 1, (size_t)length, file);
    text[*size] = '\0';
    fclose(file);
    return text;
}

/* arguments: NULL-ended, without the program itself. */
static inline run program_run(const char *const *arguments, const run_options *options)
{
    const char *program = getenv("SGFIT");
    FILE *in = tmpfile(), *out = tmpfile(), *error = tmpfile();
    if (!program || !in || !out || !error) {
        fprintf(stderr, "SGFIT is not set or there is no room for temporary files\n");
        abort();
    }
    if (options && options->input) {
        size_t size = options->input_size ? options->input_size : strlen(options->input);
        fwrite(options->input, 1, size, in);
    }
    fflush(in);
    rewind(in);
    fflush(stdout);
    fflush(stderr);
    pid_t child = fork();
    if (child == 0) {
        int from = options && options->in_path ? open(options->in_path, O_RDONLY) : fileno(in);
        int to = options && options->out_path ? open(options->out_path, O_WRONLY) : fileno(out);
        const char *argv[32] = {program};
        for (int i = 0; i < 30 && arguments[i]; i++)
            argv[i + 1] = arguments[i];
        if (dup2(from, 0) == 0 && dup2(to, 1) == 1 && dup2(fileno(error), 2) == 2)
            execv(program, (char *const *)argv);
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    run result = {.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
    size_t unused;
    fclose(in);
    result.out = program_read(out, &result.out_size);
    result.error = program_read(error, &unused);
    return result;
}

static inline void run_free(run *result)
{
    free(result->out);
    free(result->error);
}

#define RUN(options, ...) program_run((const char *const[]){__VA_ARGS__, NULL}, options)

/* Runs the program, which must refuse: that exit status, one line on standard error that names a
 * word, nothing on standard output. */
static inline void program_refuses(const char *const *arguments, int status, const char *word)
{
    run r = program_run(arguments, NULL);
    const char *end = strchr(r.error, '\n');
    if (r.status != status || r.out_size != 0 || !end || end[1] || !strstr(r.error, word))
        fail_msg("expected status %d and one line that names %s, found %d: %s", status, word,
                 r.status, r.error);
    run_free(&r);
}

#endif
