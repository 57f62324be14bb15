#include "fit/eval_block.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/progress.h"
#include "base/text.h"

enum { CHUNK_ROWS = 512 }; /* what one core takes at a time */

bool block_make(block *b, const evaluator *evaluator, const eval_format *format)
{
    *b = (block){.evaluator = evaluator, .format = format};
    b->lambda = malloc(BLOCK_ROWS * sizeof *b->lambda);
    b->angle = malloc(BLOCK_ROWS * sizeof *b->angle);
    b->cells = malloc(BLOCK_ROWS * sizeof *b->cells);
    b->row_ends = malloc(BLOCK_ROWS * sizeof *b->row_ends);
    if (b->lambda && b->angle && b->cells && b->row_ends)
        return true;
    base_error("eval: out of memory");
    return false;
}

void block_free(block *b)
{
    free(b->lambda);
    free(b->angle);
    free(b->cells);
    free(b->row_ends);
    free(b->bytes);
}

bool block_put(block *b, const char *bytes, size_t count)
{
    if (b->capacity - b->used < count) {
        size_t capacity = 2 * b->capacity + count + 4096;
        char *grown = realloc(b->bytes, capacity);
        if (!grown) {
            base_error("eval: out of memory");
            return false;
        }
        b->bytes = grown;
        b->capacity = capacity;
    }
    memcpy(b->bytes + b->used, bytes, count);
    b->used += count;
    return true;
}

size_t block_cells(const evaluator *evaluator, const eval_format *format,
                   const char *names[BLOCK_CELLS])
{
    size_t extras = evaluator_extras(evaluator, names);
    names[extras] = format->column;
    return extras + 1;
}

static void evaluate_chunk(void *context, size_t index)
{
    block *b = context;
    const char *names[BLOCK_CELLS];
    size_t extras = evaluator_extras(b->evaluator, names);
    bool is_double = strcmp(b->evaluator->precision, "f64") == 0;
    size_t end = (index + 1) * CHUNK_ROWS < b->count ? (index + 1) * CHUNK_ROWS : b->count;
    for (size_t i = index * CHUNK_ROWS; i < end; i++) {
        double extra[EVALUATOR_EXTRAS] = {0};
        double value = evaluator_value(b->evaluator, b->lambda[i], b->angle[i], extra);
        for (size_t k = 0; k < extras; k++)
            base_shortest_f64(extra[k], b->cells[i][k]);
        if (is_double)
            base_shortest_f64(value, b->cells[i][extras]);
        else
            base_shortest_f32((float)value, b->cells[i][extras]);
    }
}

static void write_cells(const block *b, size_t row, size_t cells, const char *const *names)
{
    for (size_t k = 0; k < cells; k++) {
        const char *text = b->cells[row][k];
        if (!b->format->json)
            printf(",%s", text);
        else if (strchr(text, 'n')) /* inf and nan, for which JSON has no number */
            printf(", \"%s\": \"%s\"", names[k], text);
        else
            printf(", \"%s\": %s", names[k], text);
    }
}

bool block_flush(block *b)
{
    const char *names[BLOCK_CELLS];
    size_t cells = block_cells(b->evaluator, b->format, names);
    base_parallel((b->count + CHUNK_ROWS - 1) / CHUNK_ROWS, evaluate_chunk, b);
    errno = 0;
    size_t start = 0;
    for (size_t i = 0; i < b->count && !ferror(stdout); i++) {
        if (b->format->json)
            fputs(b->written + i == 0 ? "\n  {" : ",\n  {", stdout);
        fwrite(b->bytes + start, 1, b->row_ends[i] - start, stdout);
        write_cells(b, i, cells, names);
        putchar(b->format->json ? '}' : '\n');
        start = b->row_ends[i];
    }
    b->written += b->count;
    b->count = b->used = 0;
    if (!ferror(stdout))
        return true;
    /* A reader that has seen enough is no failure worth a line. */
    if (errno != EPIPE)
        base_error("cannot write standard output: %s", strerror(errno ? errno : EIO));
    return false;
}

bool block_add(block *b, double lambda, double angle)
{
    b->lambda[b->count] = lambda;
    b->angle[b->count] = angle;
    b->row_ends[b->count] = b->used;
    b->count++;
    return (b->count < BLOCK_ROWS && b->used < BLOCK_BYTES) || block_flush(b);
}
