/* eval_block.h: rows of `sgfit eval`, gathered, evaluated on all cores and written in their order.
 */
#ifndef FIT_EVAL_BLOCK_H
#define FIT_EVAL_BLOCK_H

#include "base/text.h"
#include "fit/eval_stream.h"

enum { BLOCK_ROWS = 16384, BLOCK_BYTES = 1 << 22, BLOCK_CELLS = EVALUATOR_EXTRAS + 1 };

typedef struct block {
    const evaluator *evaluator;
    const eval_format *format;
    size_t count;
    double *lambda, *angle;
    char (*cells)[BLOCK_CELLS][BASE_NUMBER_SIZE]; /* extras, then the value, as text */
    char *bytes;      /* the rows one after the other, as they are written before the cells */
    size_t *row_ends; /* in bytes */
    size_t used, capacity;
    size_t written; /* rows before this block */
} block;

/* All return false after one line; block_flush without one where the reader of standard output has
 * left. block_free in any case. */
bool block_make(block *b, const evaluator *evaluator, const eval_format *format);
/* Appends to the text of the row that is being gathered. */
bool block_put(block *b, const char *bytes, size_t count);
/* Ends the row; flushes a block that is full. */
bool block_add(block *b, double lambda, double angle);
/* Evaluates and writes what is gathered. */
bool block_flush(block *b);
void block_free(block *b);

/* The number of cells that a row gains, and their names. */
size_t block_cells(const evaluator *evaluator, const eval_format *format,
                   const char *names[BLOCK_CELLS]);

#endif
