#include "json.h"

#include "file.h"
#include "text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One line: where in the text, counted in lines and characters from 1, what was expected and what
 * stands there. size: of the text, which may have a NUL byte. */
static void refuse_text(const char *path, const char *text, size_t size, const char *place,
                        const char *expected)
{
    enum { MOST = 20 };
    long line = 1, column = 1;
    for (const char *p = text; p < place; p++) {
        bool ends = *p == '\n', starts = ((unsigned char)*p & 0xc0) != 0x80;
        line += ends;
        column = ends ? 1 : column + starts;
    }
    int length = (int)strcspn(place, "\r\n");
    length = length < MOST ? length : MOST;
    while (length > 0 && ((unsigned char)place[length] & 0xc0) == 0x80)
        length--; /* no character is cut */
    if (length > 0)
        base_error("%s, line %ld, column %ld: expected %s, found \"%.*s\"", path, line, column,
                   expected, length, place);
    else
        base_error("%s, line %ld, column %ld: expected %s, found %s", path, line, column, expected,
                   *place                          ? "the end of the line"
                   : (size_t)(place - text) < size ? "a NUL byte"
                                                   : "the end of the file");
}

cJSON *base_json_read(const char *path)
{
    size_t size;
    char *text = base_read_file(path, &size);
    if (!text)
        return NULL;
    const char *expected, *place = base_json_fault(text, &expected);
    cJSON *root = NULL;
    if (!place && strlen(text) != size) {
        place = text + strlen(text);
        expected = "nothing after the value";
    }
    if (place)
        refuse_text(path, text, size, place, expected);
    else if (!(root = cJSON_ParseWithOpts(text, NULL, true)))
        base_error("%s: out of memory", path);
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
