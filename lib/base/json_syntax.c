/* json_syntax.c: where a text stops being JSON (RFC 8259). cJSON takes more than that (01, 1e,
 * control characters), and of a comma too many it says no place. */
#include "json.h"

#include "text.h"

#include <math.h>
#include <string.h>

enum { DEEPEST = 1000 }; /* as cJSON nests */

typedef struct reader {
    const char *at, *expected;
} reader;

static bool fail(reader *r, const char *expected)
{
    r->expected = expected;
    return false;
}

static void skip_blanks(reader *r)
{
    r->at += strspn(r->at, " \t\r\n");
}

/* ---- Numbers and strings -----------------------------------------------------------------------
 */

/* Length of the JSON number at text, 0 where it is none. */
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

static bool read_number(reader *r)
{
    size_t length = number_length(r->at);
    double value;
    if (length == 0 || strchr("+-.eE0123456789", r->at[length] ? r->at[length] : ' ') ||
        !base_parse_f64(r->at, length, &value) || isinf(value))
        return fail(r, "a number as JSON writes it, within the range of double");
    r->at += length;
    return true;
}

/* The number after \u; -1 where there is none. */
static long unicode_at(const char *text)
{
    long value = 0;
    if (text[0] != '\\' || text[1] != 'u')
        return -1;
    for (int i = 2; i < 6; i++) {
        static const char digits[] = "0123456789abcdef0123456789ABCDEF";
        const char *digit = text[i] ? strchr(digits, text[i]) : NULL;
        if (!digit)
            return -1;
        value = 16 * value + (digit - digits) % 16;
    }
    return value;
}

static bool read_escape(reader *r)
{
    if (r->at[1] && strchr("\"\\/bfnrt", r->at[1])) {
        r->at += 2;
        return true;
    }
    long first = unicode_at(r->at), second = first < 0 ? -1 : unicode_at(r->at + 6);
    bool high = first >= 0xd800 && first < 0xdc00, low = first >= 0xdc00 && first < 0xe000;
    if (first <= 0 || low || (high && !(second >= 0xdc00 && second < 0xe000)))
        return fail(r, "a character after \\ as JSON has them (\\\\ for \\ itself)");
    r->at += high ? 12 : 6;
    return true;
}

static bool read_string(reader *r)
{
    for (r->at++; *r->at != '"';) {
        if ((unsigned char)*r->at < 0x20)
            return fail(r, *r->at ? "no control character in a string" : "a closing quote");
        if (*r->at != '\\')
            r->at++;
        else if (!read_escape(r))
            return false;
    }
    r->at++;
    return true;
}

/* ---- Values ------------------------------------------------------------------------------------
 */

static bool read_value(reader *r, int depth);

static bool read_key(reader *r, const char *expected)
{
    if (*r->at != '"')
        return fail(r, expected);
    if (!read_string(r))
        return false;
    skip_blanks(r);
    if (*r->at != ':')
        return fail(r, "a colon after the key");
    r->at++;
    skip_blanks(r);
    return true;
}

/* An object or an array, whose opening bracket is next. */
static bool read_list(reader *r, int depth)
{
    bool object = *r->at == '{';
    char end = object ? '}' : ']';
    if (depth == DEEPEST)
        return fail(r, "lists and objects nested at most 1000 deep");
    r->at++;
    skip_blanks(r);
    for (bool first = true; !first || *r->at != end; first = false) {
        if (object && !read_key(r, first ? "a key in double quotes or }"
                                         : "another key in double quotes after the comma"))
            return false;
        if (!object && !first && *r->at == end)
            return fail(r, "another value after the comma");
        if (!read_value(r, depth + 1))
            return false;
        skip_blanks(r);
        if (*r->at == end)
            break;
        if (*r->at != ',')
            return fail(r, object ? "a comma or }" : "a comma or ]");
        r->at++;
        skip_blanks(r);
    }
    r->at++;
    return true;
}

static bool read_value(reader *r, int depth)
{
    static const char *const words[] = {"true", "false", "null"};
    if (*r->at == '{' || *r->at == '[')
        return read_list(r, depth);
    if (*r->at == '"')
        return read_string(r);
    if (*r->at && strchr("+-.0123456789", *r->at))
        return read_number(r);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strncmp(r->at, words[i], strlen(words[i])) == 0) {
            r->at += strlen(words[i]);
            return true;
        }
    return fail(r, "a value: a number, a string in double quotes, true, false, null, [ or {");
}

const char *base_json_fault(const char *text, const char **expected)
{
    static const char mark[] = "\xef\xbb\xbf"; /* of byte order, which cJSON takes too */
    reader r = {text, NULL};
    if (strncmp(text, mark, sizeof mark - 1) == 0)
        r.at += sizeof mark - 1;
    skip_blanks(&r);
    bool good = read_value(&r, 0);
    if (good)
        skip_blanks(&r);
    if (good && *r.at)
        good = fail(&r, "nothing after the value");
    *expected = r.expected;
    return good ? NULL : r.at;
}
