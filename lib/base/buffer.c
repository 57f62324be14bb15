#include "buffer.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text.h"

void *base_reallocate(void *memory, size_t size)
{
    void *grown = realloc(memory, size ? size : 1);
    if (!grown) {
        base_error("out of memory");
        exit(1);
    }
    return grown;
}

void *base_allocate(size_t size)
{
    return base_reallocate(NULL, size);
}

char *base_copy(const char *text, size_t length)
{
    char *copy = base_allocate(length + 1);
    memcpy(copy, text, length);
    copy[length] = '\0';
    return copy;
}

void buffer_add_n(buffer *out, const char *text, size_t length)
{
    if (out->length + length + 1 > out->capacity) {
        out->capacity = 2 * (out->length + length + 1);
        out->text = base_reallocate(out->text, out->capacity);
    }
    memcpy(out->text + out->length, text, length);
    out->length += length;
    out->text[out->length] = '\0';
}

void buffer_add(buffer *out, const char *text)
{
    buffer_add_n(out, text, strlen(text));
}

void buffer_print(buffer *out, const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    char *text = base_allocate((size_t)length + 1);
    vsnprintf(text, (size_t)length + 1, format, again);
    va_end(again);
    va_end(arguments);
    buffer_add_n(out, text, (size_t)length);
    free(text);
}

void buffer_wrap(buffer *out, const char *first, const char *next, const char *text, size_t width)
{
    size_t column = strlen(first);
    buffer_add(out, first);
    bool fresh = true;
    while (*text) {
        size_t word = strcspn(text, " ");
        if (!fresh && column + 1 + word > width) {
            buffer_print(out, "\n%s", next);
            column = strlen(next);
            fresh = true;
        }
        if (!fresh) {
            buffer_add(out, " ");
            column++;
        }
        buffer_add_n(out, text, word);
        column += word;
        fresh = false;
        text += word;
        text += strspn(text, " ");
    }
    buffer_add(out, "\n");
}

void buffer_free(buffer *out)
{
    free(out->text);
    *out = (buffer){0};
}
