/* buffer.h: text that grows. An allocation failure ends the program: nothing sensible is left. */
#ifndef BASE_BUFFER_H
#define BASE_BUFFER_H

#include <stddef.h>

typedef struct buffer {
    char *text; /* NUL-ended; NULL while empty */
    size_t length, capacity;
} buffer;

void buffer_add(buffer *out, const char *text);
void buffer_add_n(buffer *out, const char *text, size_t length);
void buffer_print(buffer *out, const char *format, ...)
    __attribute__((format(printf, 2, 3), nonnull(2)));

/* Breaks text at blanks into lines of at most width columns, the first after `first`, the others
 * after `next` (both counted). */
void buffer_wrap(buffer *out, const char *first, const char *next, const char *text, size_t width);

void buffer_free(buffer *out);

/* malloc, realloc and strndup that end the program when there is no memory. */
void *base_allocate(size_t size);
void *base_reallocate(void *memory, size_t size);
char *base_copy(const char *text, size_t length);

#endif
