/* json.h: strict reading of JSON through cJSON, and writing with numbers that read back. */
#ifndef BASE_JSON_H
#define BASE_JSON_H

#include <stdbool.h>
#include <stddef.h>

#include <cjson/cJSON.h>

/* Parses a file; NULL after one line that names the file, line and column of the error. */
cJSON *base_json_read(const char *path);

/* The first place of the text that is no JSON, and what was expected there; NULL: all of it is, no
 * string has a \u0000 and a double holds every number. */
const char *base_json_fault(const char *text, const char **expected);

/* True if every key of the object is among the NULL-ended names; else one line that names the
 * file (path), the key and what is allowed. Duplicate keys are refused too. */
bool base_json_only(const cJSON *object, const char *path, const char *const *names);

/* Required fields, false after one line that names path and key and what was expected. */
bool base_json_f64(const cJSON *object, const char *path, const char *key, double *value);
bool base_json_string(const cJSON *object, const char *path, const char *key, const char **value);
bool base_json_object(const cJSON *object, const char *path, const char *key, const cJSON **value);

/* cJSON's own printing of numbers may lose the last bit: these add numbers as their shortest
 * text. Infinity and NaN become the strings "inf", "-inf", "nan"; base_json_f64 reads those too. */
cJSON *base_json_add_f64(cJSON *object, const char *key, double value);
cJSON *base_json_number(double value);

/* The document as text, two-space indented, short arrays on one line, with a final newline;
 * malloc'ed. */
char *base_json_print(const cJSON *root);

/* The text as a JSON string, with its quotes; malloc'ed, NULL where memory is out. */
char *base_json_quote(const char *text);

#endif
