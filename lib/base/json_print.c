#include "json.h"

#include "text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* cJSON's printer is replaced whole: it puts tabs, breaks no array and rounds numbers. */

enum { WIDTH = 100 }; /* an array of plain values that fits this stays on its line */

typedef struct text_buffer {
    char *bytes;
    size_t used, capacity;
    bool failed;
} text_buffer;

static void put(text_buffer *out, const char *bytes, size_t count)
{
    if (out->failed)
        return;
    if (out->capacity - out->used < count + 1) {
        size_t capacity = 2 * out->capacity + count + 256;
        char *grown = realloc(out->bytes, capacity);
        if (!grown) {
            out->failed = true;
            return;
        }
        out->bytes = grown;
        out->capacity = capacity;
    }
    memcpy(out->bytes + out->used, bytes, count);
    out->used += count;
    out->bytes[out->used] = '\0';
}

static void put_text(text_buffer *out, const char *text)
{
    put(out, text, strlen(text));
}

static void put_break(text_buffer *out, int depth)
{
    put_text(out, "\n");
    for (int i = 0; i < depth; i++)
        put_text(out, "  ");
}

/* Bytes of the UTF-8 character at p, 0 where there is none. */
static size_t character_length(const char *p)
{
    const unsigned char *u = (const unsigned char *)p;
    size_t length = u[0] < 0x80 ? 1 : u[0] < 0xc2 ? 0 : u[0] < 0xe0 ? 2 : u[0] < 0xf0 ? 3 : 4;
    if (u[0] > 0xf4)
        return 0;
    for (size_t i = 1; i < length; i++)
        if ((u[i] & 0xc0) != 0x80)
            return 0;
    /* Longer than need be, a surrogate, beyond the last character. */
    bool wrong = (u[0] == 0xe0 && u[1] < 0xa0) || (u[0] == 0xed && u[1] > 0x9f) ||
                 (u[0] == 0xf0 && u[1] < 0x90) || (u[0] == 0xf4 && u[1] > 0x8f);
    return wrong ? 0 : length;
}

static void put_string(text_buffer *out, const char *text)
{
    put_text(out, "\"");
    for (const char *p = text ? text : ""; *p;) {
        char escape[8];
        size_t length = character_length(p);
        if (length == 0) /* bytes that are no text become the mark for that */
            put_text(out, "\xef\xbf\xbd");
        else if (length > 1 || ((unsigned char)*p >= 0x20 && *p != '"' && *p != '\\'))
            put(out, p, length);
        else if (*p == '"' || *p == '\\')
            put(out, escape, (size_t)snprintf(escape, sizeof escape, "\\%c", *p));
        else if (*p == '\n' || *p == '\t')
            put_text(out, *p == '\n' ? "\\n" : "\\t");
        else
            put(out, escape, (size_t)snprintf(escape, sizeof escape, "\\u%04x", (unsigned)*p));
        p += length ? length : 1;
    }
    put_text(out, "\"");
}

static void put_plain(text_buffer *out, const cJSON *item)
{
    char number[BASE_NUMBER_SIZE];
    if (cJSON_IsString(item))
        put_string(out, item->valuestring);
    else if (cJSON_IsRaw(item))
        put_text(out, item->valuestring);
    else if (cJSON_IsNumber(item) && isfinite(item->valuedouble))
        put_text(out, base_shortest_f64(item->valuedouble, number));
    else if (cJSON_IsNumber(item))
        put_string(out, base_shortest_f64(item->valuedouble, number));
    else
        put_text(out, cJSON_IsTrue(item) ? "true" : cJSON_IsFalse(item) ? "false" : "null");
}

static bool is_nested(const cJSON *item)
{
    return cJSON_IsArray(item) || cJSON_IsObject(item);
}

/* The array on one line; false, with nothing written, where it does not fit or is nested. */
static bool put_short_array(text_buffer *out, const cJSON *array)
{
    size_t begun = out->used, line = begun;
    while (line > 0 && out->bytes[line - 1] != '\n')
        line--;
    put_text(out, "[");
    for (const cJSON *item = array->child; item; item = item->next) {
        if (!is_nested(item)) {
            put_plain(out, item);
            put_text(out, item->next ? ", " : "");
        }
        if (is_nested(item) || out->used - line >= WIDTH) {
            out->used = begun;
            return false;
        }
    }
    put_text(out, "]");
    return true;
}

static void put_value(text_buffer *out, const cJSON *item, int depth)
{
    if (!is_nested(item)) {
        put_plain(out, item);
        return;
    }
    bool object = cJSON_IsObject(item);
    if (!object && put_short_array(out, item))
        return;
    put_text(out, object ? "{" : "[");
    for (const cJSON *child = item->child; child; child = child->next) {
        put_break(out, depth + 1);
        if (object) {
            put_string(out, child->string);
            put_text(out, ": ");
        }
        put_value(out, child, depth + 1);
        put_text(out, child->next ? "," : "");
    }
    if (item->child)
        put_break(out, depth);
    put_text(out, object ? "}" : "]");
}

static char *finish(text_buffer *out)
{
    if (!out->failed)
        return out->bytes;
    free(out->bytes);
    return NULL;
}

char *base_json_print(const cJSON *root)
{
    text_buffer out = {0};
    put_value(&out, root, 0);
    put_text(&out, "\n");
    return finish(&out);
}

char *base_json_quote(const char *text)
{
    text_buffer out = {0};
    put_string(&out, text);
    return finish(&out);
}
