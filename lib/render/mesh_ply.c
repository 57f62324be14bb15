/* mesh_ply.c: runs in the child process: whether a PLY file holds all that its header promises.
 * Assimp takes a file that ends early for a shorter one, or breaks off. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "mesh_child.h"

enum { MOST_ELEMENTS = 16, MOST_PROPERTIES = 64 };

typedef struct element {
    char name[32];
    unsigned long long count;
    int properties;
    int bytes[MOST_PROPERTIES];        /* of a value */
    int length_bytes[MOST_PROPERTIES]; /* of the length of a list; 0: not a list */
} element;

typedef struct ply {
    int elements;
    bool binary, big_endian;
    element of[MOST_ELEMENTS];
} ply;

static int size_of(const char *type)
{
    static const char *const names[] = {"char",  "uchar",   "int8",   "uint8",  "short", "ushort",
                                        "int16", "uint16",  "int",    "uint",   "int32", "uint32",
                                        "float", "float32", "double", "float64"};
    for (int i = 0; i < 16; i++)
        if (strcmp(type, names[i]) == 0)
            return i < 4 ? 1 : i < 8 ? 2 : i < 14 ? 4 : 8;
    return 0;
}

/* A line "property TYPE NAME" or "property list TYPE TYPE NAME". */
static bool add_property(ply *file, const char *line)
{
    char words[3][32];
    element *to = file->elements > 0 ? &file->of[file->elements - 1] : NULL;
    if (!to || to->properties == MOST_PROPERTIES)
        return false;
    int p = to->properties++;
    if (sscanf(line, "property list %31s %31s %31s", words[0], words[1], words[2]) == 3) {
        to->length_bytes[p] = size_of(words[0]);
        to->bytes[p] = size_of(words[1]);
        return to->length_bytes[p] > 0 && to->bytes[p] > 0;
    }
    return sscanf(line, "property %31s %31s", words[0], words[1]) == 2 &&
           (to->bytes[p] = size_of(words[0])) > 0;
}

/* The first byte behind the header, NULL where it is none that can be understood. */
static const char *read_header(const char *text, ply *file)
{
    char line[256], word[32] = "";
    bool format = false;
    for (const char *next = text; (next = strchr(next, '\n')) != NULL;) {
        size_t length = strcspn(++next, "\n");
        if (length >= sizeof line)
            return NULL;
        memcpy(line, next, length);
        line[length] = '\0';
        if (strncmp(line, "end_header", 10) == 0)
            return format && next[length] ? next + length + 1 : NULL;
        if (sscanf(line, "format %31s", word) == 1) {
            format = true;
            file->big_endian = strcmp(word, "binary_big_endian") == 0;
            file->binary = file->big_endian || strcmp(word, "binary_little_endian") == 0;
            if (!file->binary && strcmp(word, "ascii") != 0)
                return NULL;
        } else if (strncmp(line, "element ", 8) == 0) {
            if (file->elements == MOST_ELEMENTS)
                return NULL;
            element *to = &file->of[file->elements++];
            if (sscanf(line, "element %31s %llu", to->name, &to->count) != 2)
                return NULL;
        } else if (strncmp(line, "property ", 9) == 0 && !add_property(file, line)) {
            return NULL;
        }
    }
    return NULL;
}

/* A length as a number in the text; -1 where there is none. */
static long long next_number(const char **next, const char *end)
{
    while (*next < end && strchr(" \t\r\n", **next))
        ++*next;
    const char *begin = *next;
    while (*next < end && !strchr(" \t\r\n", **next))
        ++*next;
    return *next > begin ? strtoll(begin, NULL, 10) : -1;
}

static long long next_binary(const char **next, const char *end, int bytes, bool big_endian)
{
    unsigned long long value = 0;
    if (end - *next < bytes)
        return -1;
    for (int i = 0; i < bytes; i++) {
        unsigned byte = (unsigned char)(*next)[big_endian ? i : bytes - 1 - i];
        value = value << 8 | byte;
    }
    *next += bytes;
    return (long long)value;
}

/* Steps over one value or list; false where the file ends before. */
static bool skip(const ply *file, const element *of, int p, const char **next, const char *end)
{
    long long count = 1;
    if (of->length_bytes[p])
        count = file->binary ? next_binary(next, end, of->length_bytes[p], file->big_endian)
                             : next_number(next, end);
    if (count < 0 || count > end - *next)
        return false;
    if (file->binary) {
        if (count * of->bytes[p] > end - *next)
            return false;
        *next += count * of->bytes[p];
        return true;
    }
    const char *before = *next;
    for (; count > 0 && *next < end; count--) {
        before = *next;
        next_number(next, end);
    }
    return count == 0 && (of->length_bytes[p] || *next > before);
}

bool mesh_ply_is_whole(const char *path, char why[MESH_WHY])
{
    size_t size;
    char *text = base_read_file(path, &size);
    ply file = {0};
    const char *next = text ? read_header(text, &file) : NULL;
    snprintf(why, MESH_WHY, "no header of PLY");
    bool good = next != NULL;
    for (int e = 0; good && e < file.elements; e++) {
        const element *of = &file.of[e];
        for (unsigned long long i = 0; good && i < of->count && of->properties > 0; i++) {
            for (int p = 0; good && p < of->properties; p++)
                good = skip(&file, of, p, &next, text + size);
            if (!good)
                snprintf(why, MESH_WHY, "element %s: %llu of the %llu that its header promises",
                         of->name, i, of->count);
        }
    }
    free(text);
    return good;
}
