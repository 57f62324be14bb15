/* file.h: output files that appear whole or not at all, and whole-file reading. */
#ifndef BASE_FILE_H
#define BASE_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* An output that is written beside its final place and renamed over it by base_output_close. */
typedef struct base_output {
    FILE *stream;
    char *path;
    char *temporary;
} base_output;

/* All return false after printing one line that names the path and what went wrong. */
bool base_output_open(base_output *output, const char *path);
bool base_output_close(base_output *output);   /* flush, sync, check, rename; removes on failure */
void base_output_discard(base_output *output); /* leaves what was there before untouched */
bool base_write_file(const char *path, const void *bytes, size_t size); /* the three in one */

/* Whether base_output_open would take the path, and whether base_make_directory and then files in
 * it would: asked before long work, leaving nothing. False after one line. */
bool base_can_write(const char *path);
bool base_can_fill(const char *folder);

/* Reads a whole file, adds a NUL; free() it. NULL after one line on standard error. */
char *base_read_file(const char *path, size_t *size);

/* mkdir -p; false after one line. */
bool base_make_directory(const char *path);

/* Whether both paths, whose files need not exist, name one file that writing the second would
 * replace. Devices and pipes are never that: what is written there follows. */
bool base_same_file(const char *a, const char *b);

/* "folder/name", malloc'ed. */
char *base_join(const char *folder, const char *name);

/* Names in folder that end in suffix, sorted bytewise; malloc'ed, free with base_list_free.
 * False after one line. */
bool base_list(const char *folder, const char *suffix, char ***names, size_t *count);
void base_list_free(char **names, size_t count);

/* The source tree: --root where given, else what CMake compiled in. */
const char *base_source_root(void);
void base_set_source_root(const char *path);

/* Flushes standard output; false after one line if that or any earlier write to it failed. */
bool base_finish_stdout(void);

#endif
