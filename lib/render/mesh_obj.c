/* mesh_obj.c: runs in the child process: the statements of an OBJ file, written again in the few
 * forms that Assimp reads right. As it stands it leaves out without a word a vertex with a number
 * such as .3, one behind blanks or a byte order mark, one with 7 numbers and so on, and every face
 * behind it takes wrong corners. */
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/buffer.h"
#include "mesh_child.h"

typedef struct obj {
    char *next;         /* the statement after this one */
    unsigned long line; /* where this one begins, and the next one */
    unsigned long next_line;
    unsigned long vertices, normals, faces;
    unsigned long farthest[2], farthest_line[2]; /* the largest index of a vertex, of a normal */
    buffer out, corners;
    char *why;
} obj;

static const char digits[] = "0123456789", blanks[] = " \t\v\f";

static bool wrong(const obj *file, const char *format, ...) __attribute__((format(printf, 2, 3)));
static bool wrong(const obj *file, const char *format, ...)
{
    int begin = snprintf(file->why, MESH_WHY, "line %lu: ", file->line);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(file->why + begin, MESH_WHY - (size_t)begin, format, arguments);
    va_end(arguments);
    return false;
}

/* The line as text, lines joined by a backslash as one; NULL at the end. A comment goes on no
 * further: it may well end in the name of a folder. */
static char *next_statement(obj *file)
{
    char *begin = file->next + strspn(file->next, blanks), *end = begin;
    file->line = ++file->next_line;
    if (!*begin)
        return NULL;
    for (;;) {
        end += strcspn(end, "\r\n");
        size_t feed = end[0] == '\r' && end[1] == '\n' ? 2 : end[0] != '\0';
        file->next = end + feed;
        if (feed == 0 || end == begin || end[-1] != '\\' || begin[0] == '#')
            break;
        memset(end - 1, ' ', feed + 1);
        file->next_line++;
        end = file->next;
    }
    *end = '\0';
    while (end > begin && strchr(blanks, end[-1]))
        *--end = '\0';
    return begin;
}

/* The next word, NULL behind the last and before a comment. */
static char *next_word(char **at)
{
    char *word = *at + strspn(*at, blanks);
    if (!*word || *word == '#')
        return NULL;
    *at = word + strcspn(word, " \t\v\f#");
    if (**at == '#' && (*at)[-1] == '.') /* of a number such as 1.#IND, which is none */
        *at += strcspn(*at, blanks);
    if (**at == '#')
        **at = '\0';
    else if (**at)
        *(*at)++ = '\0';
    return word;
}

/* The digits of a number stay as they are; what is added are those that may be left out. */
static bool add_number(obj *file, const char *word)
{
    const char *whole = word + (*word == '-' || *word == '+');
    size_t wholes = strspn(whole, digits);
    const char *part = whole + wholes + (whole[wholes] == '.');
    size_t parts = part > whole + wholes ? strspn(part, digits) : 0;
    const char *power = part + parts, *last = power;
    size_t powers = 0;
    if (*power == 'e' || *power == 'E') {
        last += 1 + (power[1] == '-' || power[1] == '+');
        powers = strspn(last, digits);
        last += powers;
    }
    buffer_add(&file->out, *word == '-' ? " -" : " ");
    if (strncasecmp(whole, "nan", 3) == 0 || strncasecmp(whole, "inf", 3) == 0) {
        buffer_add_n(&file->out, whole, 3);
    } else if (wholes + parts == 0 || *last || (last > power && powers == 0)) {
        return wrong(file, "expected a number, found %.40s", word);
    } else if (wholes > 18 || powers > 2 || (parts > 15 && strspn(whole, "0.") > 8)) {
        /* more than Assimp counts to, or digits only where it no longer looks */
        float value = strtof(whole, NULL);
        char text[32];
        snprintf(text, sizeof text, "%.9e", (double)value);
        buffer_add(&file->out, text); /* "inf" too */
    } else {
        buffer_add_n(&file->out, wholes ? whole : "0", wholes ? wholes : 1);
        buffer_add(&file->out, ".");
        buffer_add_n(&file->out, parts ? part : "0", parts ? parts : 1);
        buffer_add_n(&file->out, power, (size_t)(last - power));
    }
    return true;
}

/* x y z, with a weight or a colour behind them. Assimp divides by the weight. */
static bool add_vector(obj *file, const char *kind, char *rest)
{
    char *words[8];
    int count = 0;
    for (char *word; count < 8 && (word = next_word(&rest)) != NULL;)
        words[count++] = word;
    bool is_vertex = kind[1] == '\0';
    if (count < 3 || (is_vertex && count != 3 && count != 4 && count != 6 && count != 7))
        return wrong(file, "expected 3%s numbers behind %s, found %d",
                     is_vertex ? ", 4, 6 or 7" : "", kind, count);
    buffer_add(&file->out, kind);
    for (int i = 0; i < (is_vertex && count == 4 ? 4 : 3); i++)
        if (!add_number(file, words[i]))
            return false;
    buffer_add(&file->out, "\n");
    ++*(is_vertex ? &file->vertices : &file->normals);
    return true;
}

/* An index as it counts from the begin of the file; 0 where none is given. at moves behind it. */
static bool read_index(const char **at, unsigned long count, unsigned long *index)
{
    bool backwards = **at == '-';
    const char *begin = *at + (backwards || **at == '+');
    size_t length = strspn(begin, digits);
    *index = 0;
    *at = begin + length;
    if (length == 0)
        return !backwards;
    unsigned long value = length < 10 ? strtoul(begin, NULL, 10) : 0;
    *index = backwards && value <= count ? count + 1 - value : value;
    return value > 0 && !(backwards && value > count);
}

/* vertex, vertex/texture, vertex//normal or vertex/texture/normal: the first and the last. */
static bool read_corner(obj *file, const char *word, unsigned long corner[2])
{
    const char *at = word;
    unsigned long texture;
    corner[1] = 0;
    bool good = read_index(&at, file->vertices, &corner[0]) && corner[0] > 0;
    if (good && *at == '/') {
        at++;
        good = read_index(&at, ULONG_MAX - 1, &texture);
        if (good && *at == '/') {
            at++;
            good = read_index(&at, file->normals, &corner[1]);
        }
    }
    if (!good || *at)
        return wrong(file, "expected indices of a vertex and a normal, found %.40s", word);
    for (int i = 0; i < 2; i++)
        if (corner[i] > file->farthest[i]) {
            file->farthest[i] = corner[i];
            file->farthest_line[i] = file->line;
        }
    return true;
}

static void add_index(buffer *out, char before, unsigned long index)
{
    char text[24], *begin = text + sizeof text;
    do
        *--begin = (char)('0' + index % 10);
    while ((index /= 10) > 0);
    *--begin = before;
    buffer_add_n(out, begin, (size_t)(text + sizeof text - begin));
}

/* A face, or points or lines. Texture coordinates are of no use here and left out. Normals are
 * taken where every corner has one: Assimp gives those that there are to the first corners. */
static bool add_face(obj *file, const char *kind, char *rest)
{
    bool normals = true;
    file->corners.length = 0;
    for (char *word; (word = next_word(&rest)) != NULL;) {
        unsigned long corner[2];
        if (!read_corner(file, word, corner))
            return false;
        normals = normals && corner[1] > 0;
        buffer_add_n(&file->corners, (const char *)corner, sizeof corner);
    }
    file->faces++;
    buffer_add_n(&file->out, kind, 1);
    for (size_t at = 0; at < file->corners.length; at += 2 * sizeof(unsigned long)) {
        unsigned long corner[2];
        memcpy(corner, file->corners.text + at, sizeof corner);
        add_index(&file->out, ' ', corner[0]);
        if (normals && *kind == 'f') {
            buffer_add(&file->out, "/");
            add_index(&file->out, '/', corner[1]);
        }
    }
    buffer_add(&file->out, "\n");
    return true;
}

/* What is none of these says nothing about triangles. */
static bool add_statement(obj *file, char *statement)
{
    static const char *const names[] = {"g", "o", "usemtl", "mtllib"};
    size_t length = strcspn(statement, blanks);
    char *rest = statement + length + strspn(statement + length, blanks);
    statement[length] = '\0';
    if (strcmp(statement, "v") == 0 || strcmp(statement, "vn") == 0)
        return add_vector(file, statement, rest);
    if (strcmp(statement, "f") == 0 || strcmp(statement, "fo") == 0 ||
        strcmp(statement, "l") == 0 || strcmp(statement, "p") == 0)
        return add_face(file, statement, rest);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(statement, names[i]) == 0) {
            buffer_add(&file->out, statement);
            buffer_add(&file->out, *rest ? " " : "");
            buffer_add(&file->out, rest);
            buffer_add(&file->out, "\n");
        }
    return true;
}

static bool add_statements(obj *file)
{
    for (char *statement; (statement = next_statement(file)) != NULL;)
        if (!add_statement(file, statement))
            return false;
    const unsigned long counts[2] = {file->vertices, file->normals};
    for (int i = 0; i < 2; i++)
        if (file->farthest[i] > counts[i]) {
            file->line = file->farthest_line[i];
            return wrong(file, "expected an index up to %lu, the number of %s, found %lu",
                         counts[i], i == 0 ? "vertices" : "normals", file->farthest[i]);
        }
    if (file->faces == 0)
        snprintf(file->why, MESH_WHY, "no faces in it");
    return file->faces > 0;
}

bool mesh_obj(char *text, size_t size, char **mended, size_t *mended_size, char why[MESH_WHY])
{
    obj file = {.next = text, .why = why};
    bool good = memchr(text, 0, size) == NULL;
    snprintf(why, MESH_WHY, "no text: it holds a byte that is 0");
    if (strncmp(text, "\xef\xbb\xbf", 3) == 0)
        file.next += 3;
    buffer_add(&file.out, "# written again\n"); /* Assimp refuses what is shorter than this */
    good = good && add_statements(&file);
    buffer_free(&file.corners);
    if (!good)
        buffer_free(&file.out);
    *mended = file.out.text;
    *mended_size = file.out.length;
    return good;
}
