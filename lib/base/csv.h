/* csv.h: reading CSV row by row, fields kept as text. */
#ifndef BASE_CSV_H
#define BASE_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct base_csv {
    FILE *stream;
    const char *name; /* for diagnostics: a path or "standard input" */
    long line;        /* of the current row, from 1 */
    size_t columns;   /* of the header */
    char **header;
    char *row;        /* the current row as read, without its line end */
    char **fields;    /* of the current row; point into a copy */
    size_t *lengths;
    /* buffers of the reader */
    char *buffer, *copy;
    size_t capacity, copy_capacity;
    size_t row_length;
} base_csv;

/* Reads the header. False after one line: empty input, duplicate names. */
bool base_csv_open(base_csv *csv, FILE *stream, const char *name);
/* Column of that name or -1. */
int base_csv_column(const base_csv *csv, const char *name);
/* Next row: 1, 0 at the end, -1 after one line that names the file and line (wrong number of
 * fields, unterminated quote, read error). Blank lines are skipped; CRLF is accepted. */
int base_csv_next(base_csv *csv);
/* Field of the current row as a finite number; false after one line that names file, line and
 * column and what was expected. */
bool base_csv_f64(const base_csv *csv, int column, double *value);
void base_csv_close(base_csv *csv);

#endif
