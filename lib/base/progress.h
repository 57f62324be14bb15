/* progress.h: one progress line on standard error, only where that is a terminal and the work
 * takes more than a second. Thread-safe. */
#ifndef BASE_PROGRESS_H
#define BASE_PROGRESS_H

#include <stddef.h>

typedef struct base_progress base_progress;

base_progress *base_progress_begin(const char *what, size_t steps);
void base_progress_step(base_progress *progress, const char *item); /* item may be NULL */
void base_progress_end(base_progress *progress);                    /* clears the line */

/* Runs job(context, i) for i in [0, count) on the machine's cores; job must not depend on order. */
void base_parallel(size_t count, void (*job)(void *context, size_t index), void *context);

#endif
