/* csv.h: reading CSV row by row, fields kept as text. */
#ifndef BASE_CSV_H
#define BASE_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { BASE_CSV_LONGEST_ROW = 1 << 24 }; /* bytes; a longer row is refused */

typedef struct base_csv {
    FILE *stream;
    const char *name; /* for diagnostics: a path or "standard input" */
    long line;        /* where the current row begins, from 1 */
    size_t columns;   /* of the header */
    char **header;    /* names, without quotes and surrounding blanks */
    char *row;        /* the current row as read, without its line end, NUL-terminated */
    size_t row_length;
    char **fields; /* of the current row, without quotes, NUL-terminated */
    size_t *lengths;
    /* of the reader */
    long next_line;
    size_t field_count, field_capacity;
    size_t *starts;
    char *copy;
    size_t row_capacity;
} base_csv;

/* Reads the header. False after one line: empty input, duplicate names, bad quotes; close
 * it then too. A byte order mark is skipped. Quotes as in RFC 4180. */
bool base_csv_open(base_csv *csv, FILE *stream, const char *name);
/* Column of that name or -1. */
int base_csv_column(const base_csv *csv, const char *name);
/* Next row: 1, 0 at the end, -1 after one line that names the file and line (wrong number of
 * fields, unterminated quote, NUL byte, read error). Blank lines are skipped; CRLF is accepted. */
int base_csv_next(base_csv *csv);
/* Field of the current row as a finite number; false after one line that names file, line and
 * column and what was expected. */
bool base_csv_f64(const base_csv *csv, int column, double *value);
/* The line that says so: "NAME, line N, column C: expected EXPECTED, found "FIELD"". */
void base_csv_error(const base_csv *csv, int column, const char *expected);
void base_csv_close(base_csv *csv);

#endif
