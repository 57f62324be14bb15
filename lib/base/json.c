#include "json.h"

#include "file.h"
#include "text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static long line_of(const char *text, const char *place)
{
    long line = 1;
    for (const char *p = text; p < place; p++)
        line += *p == '\n';
    return line;
}

/* Length of the JSON number at text, 0 where it is none: cJSON takes 01, 1. and 1e too. */
static size_t number_length(const char *text)
{
    const char *p = text + (*text == '-');
    size_t digits = strspn(p, "0123456789");
    if (digits == 0 || (digits > 1 && *p == '0'))
        return 0;
    p += digits;
    if (*p == '.') {
        digits = strspn(++p, "0123456789");
        if (digits == 0)
            return 0;
        p += digits;
    }
    if (*p == 'e' || *p == 'E') {
        p++;
        p += *p == '-' || *p == '+';
        digits = strspn(p, "0123456789");
        if (digits == 0)
            return 0;
        p += digits;
    }
    return (size_t)(p - text);
}

/* First place that cJSON would let through although it is no JSON; NULL where there is none. */
static const char *find_lenient(const char *text, const char **expected)
{
    for (const char *p = text; *p;) {
        if (*p == '"') {
            for (p++; *p && *p != '"'; p++) {
                *expected = "no control character in a string";
                if ((unsigned char)*p < 0x20)
                    return p;
                if (*p == '\\' && p[1])
                    p++;
            }
            p += *p == '"';
        } else if (*p == '-' || *p == '+' || *p == '.' || (*p >= '0' && *p <= '9')) {
            size_t length = number_length(p);
            double value;
            *expected = "a number as JSON writes it, within the range of double";
            if (length == 0 || strchr("+-.eE0123456789", p[length] ? p[length] : ' ') ||
                !base_parse_f64(p, length, &value) || isinf(value))
                return p;
            p += length;
        } else if ((unsigned char)*p < 0x20 && !strchr("\t\n\r", *p)) {
            *expected = "no control character";
            return p;
        } else {
            p++;
        }
    }
    return NULL;
}

cJSON *base_json_read(const char *path)
{
    size_t size;
    char *text = base_read_file(path, &size);
    if (!text)
        return NULL;
    const char *end = text, *place, *expected;
    cJSON *root = NULL;
    if (strlen(text) != size) {
        base_error("%s, line %ld: expected JSON text, found a NUL byte", path,
                   line_of(text, text + strlen(text)));
    } else if ((place = find_lenient(text, &expected)) != NULL) {
        base_error("%s, line %ld: expected %s, found \"%.20s\"", path, line_of(text, place),
                   expected, place);
    } else if (!(root = cJSON_ParseWithOpts(text, &end, true))) {
        base_error("%s, line %ld: expected JSON, found %s%.20s%s", path, line_of(text, end),
                   *end ? "\"" : "the end of the file", end, *end ? "\"" : "");
    }
    free(text);
    return root;
}

/* "a", "b" or "c" into text, cut where it is too long. */
static void join_names(const char *const *names, char *text, size_t size)
{
    text[0] = '\0';
    for (size_t i = 0; names[i]; i++) {
        size_t used = strlen(text);
        snprintf(text + used, size - used, "%s\"%s\"", i == 0 ? "" : (names[i + 1] ? ", " : " or "),
                 names[i]);
    }
}

bool base_json_only(const cJSON *object, const char *path, const char *const *names)
{
    if (!cJSON_IsObject(object)) {
        base_error("%s: expected a JSON object", path);
        return false;
    }
    for (const cJSON *item = object->child; item; item = item->next) {
        size_t i = 0;
        while (names[i] && strcmp(names[i], item->string) != 0)
            i++;
        if (!names[i]) {
            char allowed[1024];
            join_names(names, allowed, sizeof allowed);
            base_error("%s: unknown key \"%.60s\", expected %s", path, item->string, allowed);
            return false;
        }
        for (const cJSON *other = object->child; other != item; other = other->next) {
            if (strcmp(other->string, item->string) == 0) {
                base_error("%s: key \"%.60s\" is given twice, expected once", path, item->string);
                return false;
            }
        }
    }
    return true;
}

static const char *what_is(const cJSON *item)
{
    if (!item)
        return "nothing";
    if (cJSON_IsString(item))
        return "a string";
    if (cJSON_IsNumber(item) || cJSON_IsRaw(item))
        return "a number";
    if (cJSON_IsObject(item))
        return "an object";
    if (cJSON_IsArray(item))
        return "an array";
    return cJSON_IsNull(item) ? "null" : "true or false";
}

static bool refuse(const cJSON *item, const char *path, const char *key, const char *expected)
{
    base_error("%s: key \"%s\": expected %s, found %s", path, key, expected, what_is(item));
    return false;
}

bool base_json_f64(const cJSON *object, const char *path, const char *key, double *value)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    if (cJSON_IsNumber(item)) {
        *value = item->valuedouble;
        return true;
    }
    /* Written but not yet read back: the text of base_json_number. */
    if (cJSON_IsRaw(item) && base_parse_f64(item->valuestring, strlen(item->valuestring), value))
        return true;
    if (cJSON_IsString(item)) {
        static const char *const words[] = {"inf", "-inf", "nan"};
        for (size_t i = 0; i < sizeof words / sizeof *words; i++)
            if (strcmp(item->valuestring, words[i]) == 0)
                return base_parse_f64(words[i], strlen(words[i]), value);
    }
    return refuse(item, path, key, "a number, \"inf\", \"-inf\" or \"nan\"");
}

bool base_json_string(const cJSON *object, const char *path, const char *key, const char **value)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    if (!cJSON_IsString(item))
        return refuse(item, path, key, "a string");
    *value = item->valuestring;
    return true;
}

bool base_json_object(const cJSON *object, const char *path, const char *key, const cJSON **value)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    if (!cJSON_IsObject(item))
        return refuse(item, path, key, "an object");
    *value = item;
    return true;
}

cJSON *base_json_number(double value)
{
    char text[BASE_NUMBER_SIZE];
    base_shortest_f64(value, text);
    return isfinite(value) ? cJSON_CreateRaw(text) : cJSON_CreateString(text);
}

cJSON *base_json_add_f64(cJSON *object, const char *key, double value)
{
    cJSON *item = base_json_number(value);
    if (item && !cJSON_AddItemToObject(object, key, item)) {
        cJSON_Delete(item);
        return NULL;
    }
    return item;
}
