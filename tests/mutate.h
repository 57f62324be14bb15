/* mutate.h: damages text at random, always in the same way. */
#ifndef TESTS_MUTATE_H
#define TESTS_MUTATE_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

static uint64_t random_state;

static inline size_t random_below(size_t end)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (size_t)((random_state >> 11) % end);
}

enum { MOST = 1 << 16 }; /* bytes; the text that is damaged must have fewer */

/* A few changes: a byte, a bit, a piece of syntax, a piece left out or written twice, the end cut.
 */
static inline size_t mutate(const char *from, char *to)
{
    static const char *const pieces[] = {
        ",", "\"",    "\n",    "\r\n", "\"\"",         "{",    "}",    "[",      "]", ":", "nan",
        "-", "1e400", "0x1p3", "\\u",  "\xef\xbb\xbf", "\xff", "null", "1e-999", ".", "\t"};
    size_t size = strlen(from);
    memcpy(to, from, size);
    for (size_t changes = 1 + random_below(4); changes > 0 && size > 0; changes--) {
        size_t at = random_below(size), length = 1 + random_below(size - at);
        const char *piece = pieces[random_below(sizeof pieces / sizeof *pieces)];
        switch (random_below(6)) {
        case 0:
            to[at] = (char)random_below(256);
            break;
        case 1:
            to[at] = (char)(to[at] ^ (1 << random_below(8)));
            break;
        case 2:
            if (size + strlen(piece) > MOST)
                break;
            memmove(to + at + strlen(piece), to + at, size - at);
            memcpy(to + at, piece, strlen(piece));
            size += strlen(piece);
            break;
        case 3:
            memmove(to + at, to + at + length, size - at - length);
            size -= length;
            break;
        case 4:
            if (size + length > MOST)
                break;
            memmove(to + at + length, to + at, size - at);
            size += length;
            break;
        default:
            size = at;
            break;
        }
    }
    return size;
}

#endif
