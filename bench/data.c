/* data.c: see data.h. */
#include "data.h"

#include <stdlib.h>
#include <string.h>

#include "base/text.h"

static void *needed(void *pointer)
{
    if (!pointer) {
        base_error("out of memory while collecting data for a plot");
        abort();
    }
    return pointer;
}

data_table *data_new(const char *const *names)
{
    data_table *table = needed(calloc(1, sizeof *table));
    table->names = names;
    while (names[table->columns])
        table->columns++;
    return table;
}

void data_row(data_table *table, const double *values)
{
    if (table->rows == table->capacity) {
        table->capacity = table->capacity ? 2 * table->capacity : 64;
        table->cells =
            needed(realloc(table->cells, table->capacity * table->columns * sizeof *table->cells));
    }
    memcpy(table->cells + table->rows * table->columns, values, table->columns * sizeof *values);
    table->rows++;
}

double data_at(const data_table *table, size_t row, size_t column)
{
    return table->cells[row * table->columns + column];
}

void data_free(data_table *table)
{
    if (!table)
        return;
    free(table->cells);
    free(table);
}

void data_csv(const data_table *table, FILE *out)
{
    char number[BASE_NUMBER_SIZE];
    for (size_t c = 0; c < table->columns; c++)
        fprintf(out, "%s%s", c ? "," : "", table->names[c]);
    fputc('\n', out);
    for (size_t r = 0; r < table->rows; r++) {
        for (size_t c = 0; c < table->columns; c++)
            fprintf(out, "%s%s", c ? "," : "", base_shortest_f64(data_at(table, r, c), number));
        fputc('\n', out);
    }
}
