/* data.h: a table of numbers with named columns: what a plot draws and what its CSV holds. */
#ifndef BENCH_DATA_H
#define BENCH_DATA_H

#include <stddef.h>
#include <stdio.h>

typedef struct data_table {
    size_t columns, rows, capacity;
    const char *const *names;
    double *cells; /* row by row */
} data_table;

/* names: NULL-ended, kept by the caller as long as the table lives. */
data_table *data_new(const char *const *names);
void data_row(data_table *table, const double *values); /* `columns` of them, copied */
double data_at(const data_table *table, size_t row, size_t column);
void data_free(data_table *table);

/* As CSV: a header line, then shortest numbers. */
void data_csv(const data_table *table, FILE *out);

#endif
