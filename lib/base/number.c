#include "text.h"

#include "c_locale.h"

#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static locale_t c_locale;
static pthread_once_t c_locale_once = PTHREAD_ONCE_INIT;

static void make_c_locale(void)
{
    c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
}

locale_t base_enter_c_locale(void)
{
    pthread_once(&c_locale_once, make_c_locale);
    return c_locale ? uselocale(c_locale) : (locale_t)0;
}

void base_leave_c_locale(locale_t before)
{
    if (before)
        uselocale(before);
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool equals_ignoring_case(const char *text, size_t length, const char *word)
{
    if (strlen(word) != length)
        return false;
    for (size_t i = 0; i < length; i++)
        if ((text[i] | 0x20) != word[i])
            return false;
    return true;
}

/* Whether text is [sign] digits [. digits] [e [sign] digits] with a digit before the exponent.
 * Where it is and the first 19 digits and the power say all, *quick gets the exact value: two
 * numbers that are exact in double have a correctly rounded product or quotient. */
static bool check_number(const char *p, const char *end, double *quick, bool *exact)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    bool negative = p < end && *p == '-';
    if (p < end && (*p == '-' || *p == '+'))
        p++;
    uint64_t mantissa = 0;
    int digits = 0, scale = 0;
    bool point = false, lost = false;
    for (; p < end && (is_digit(*p) || (*p == '.' && !point)); p++) {
        if (*p == '.') {
            point = true;
            continue;
        }
        digits++;
        if (mantissa < UINT64_C(100000000000000000)) {
            mantissa = mantissa * 10 + (uint64_t)(*p - '0');
            scale -= point;
        } else {
            lost = true;
        }
    }
    if (digits == 0)
        return false;
    int power = 0;
    if (p < end && (*p == 'e' || *p == 'E')) {
        p++;
        bool down = p < end && *p == '-';
        if (p < end && (*p == '-' || *p == '+'))
            p++;
        if (p == end)
            return false;
        for (; p < end && is_digit(*p); p++)
            if (power < 100000)
                power = power * 10 + (*p - '0');
        power = down ? -power : power;
    }
    if (p != end)
        return false;
    scale += power;
    *exact = !lost && mantissa <= (UINT64_C(1) << 53) && scale >= -22 && scale <= 22;
    if (*exact) {
        double m = (double)mantissa;
        double v = scale < 0 ? m / powers[-scale] : m * powers[scale];
        *quick = negative ? -v : v;
    }
    return true;
}

static bool parse_word(const char *text, size_t length, double *value)
{
    bool negative = length > 0 && text[0] == '-';
    if (length > 0 && (text[0] == '-' || text[0] == '+')) {
        text++;
        length--;
    }
    if (equals_ignoring_case(text, length, "inf") || equals_ignoring_case(text, length, "infinity"))
        *value = negative ? -(double)INFINITY : (double)INFINITY;
    else if (equals_ignoring_case(text, length, "nan"))
        *value = (double)NAN;
    else
        return false;
    return true;
}

bool base_parse_f64(const char *text, size_t length, double *value)
{
    while (length > 0 && is_blank(text[0])) {
        text++;
        length--;
    }
    while (length > 0 && is_blank(text[length - 1]))
        length--;
    bool exact = false;
    if (!check_number(text, text + length, value, &exact))
        return parse_word(text, length, value);
    if (exact)
        return true;
    char small[64], *copy = length < sizeof small ? small : malloc(length + 1);
    if (!copy)
        return false;
    memcpy(copy, text, length);
    copy[length] = '\0';
    locale_t before = base_enter_c_locale();
    *value = strtod(copy, NULL);
    base_leave_c_locale(before);
    if (copy != small)
        free(copy);
    return true;
}

bool base_parse_long(const char *text, long *value)
{
    const char *p = text;
    bool negative = *p == '-';
    if (*p == '-' || *p == '+')
        p++;
    if (!is_digit(*p))
        return false;
    long sum = 0;
    for (; is_digit(*p); p++)
        if (__builtin_mul_overflow(sum, 10L, &sum) ||
            __builtin_add_overflow(sum, negative ? -(long)(*p - '0') : (long)(*p - '0'), &sum))
            return false;
    if (*p != '\0')
        return false;
    *value = sum;
    return true;
}
