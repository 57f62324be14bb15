#include "text.h"

#include "c_locale.h"

#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A decimal number: digits d[0].d[1]d[2]... times ten to the exponent. */
typedef struct decimal {
    char digits[24];
    int count;
    int exponent;
} decimal;

typedef bool (*reads_back)(const char *text, const void *value);

static bool reads_back_f64(const char *text, const void *value)
{
    return strtod(text, NULL) == *(const double *)value;
}

static bool reads_back_f32(const char *text, const void *value)
{
    return strtof(text, NULL) == *(const float *)value;
}

static void decimal_read(decimal *d, const char *scientific)
{
    d->count = 0;
    const char *p = scientific;
    for (; *p && *p != 'e'; p++)
        if (*p != '.')
            d->digits[d->count++] = *p;
    d->exponent = *p ? (int)strtol(p + 1, NULL, 10) : 0;
    while (d->count > 1 && d->digits[d->count - 1] == '0')
        d->count--;
}

/* The next larger decimal of as many digits, in scientific form; false where 9 would carry. */
static bool next_decimal(char *scientific)
{
    char *last = strchr(scientific, 'e');
    if (!last || last[-1] < '0' || last[-1] >= '9')
        return false;
    last[-1]++;
    return true;
}

/* The fewest digits that read back. From `certain` digits down to one every decimal is unique, so
 * stripping zeros finds the shortest there; a subnormal has fewer, and is searched from one. */
static void shortest_digits(decimal *d, double magnitude, const void *value, reads_back same,
                            int certain, int most, bool subnormal)
{
    char text[BASE_NUMBER_SIZE];
    int unused;
    bool power_of_two = frexp(magnitude, &unused) == 0.5;
    for (int digits = subnormal ? 1 : certain; digits <= most; digits++) {
        snprintf(text, sizeof text, "%.*e", digits - 1, magnitude);
        /* Below a power of two the numbers lie twice as dense, so that the nearest decimal may
         * read back as something else while the next one up does not. */
        if (digits == most || same(text, value) ||
            (power_of_two && next_decimal(text) && same(text, value)))
            break;
    }
    decimal_read(d, text);
}

/* The same from one conversion. With all digits known as a whole number n, half the distance to
 * the next double (float) is a number of units of its last digit, and so is what rounding to fewer
 * digits moves it by. False where that leaves a doubt, which takes a conversion back to settle. */
static bool quick_digits(decimal *d, double magnitude, int certain, int most, int precision)
{
    char text[BASE_NUMBER_SIZE];
    int unused;
    double mantissa = frexp(magnitude, &unused);
    if (mantissa == 0.5)
        return false;
    snprintf(text, sizeof text, "%.*e", most - 1, magnitude);
    uint64_t n = (uint64_t)(text[0] - '0');
    for (const char *p = text + 2; *p != 'e'; p++)
        n = 10 * n + (uint64_t)(*p - '0');
    double half = (double)n * ldexp(1.0, -precision - 1) / mantissa;
    uint64_t unit = 1;
    for (int i = certain; i < most; i++)
        unit *= 10;
    for (; unit > 1; unit /= 10) {
        uint64_t below = n % unit, moved = below < unit - below ? below : unit - below;
        /* n itself is rounded by up to half a unit. */
        if ((double)moved - 0.6 > half)
            continue;
        if ((double)moved + 0.6 > half || 2 * below == unit)
            return false;
        n = n - below + (2 * below > unit ? unit : 0);
        break;
    }
    const char *exponent = strchr(text, 'e');
    d->exponent = (int)strtol(exponent + 1, NULL, 10);
    d->count = snprintf(d->digits, sizeof d->digits, "%" PRIu64, n);
    if (d->count > most) /* 9.99...  became 10 */
        d->exponent++;
    while (d->count > 1 && d->digits[d->count - 1] == '0')
        d->count--;
    return true;
}

/* Fixed where that is not longer than scientific, or for a whole number up to seven digits. */
static char *write_decimal(const decimal *d, bool negative, char text[BASE_NUMBER_SIZE])
{
    char power[8];
    int power_length = snprintf(power, sizeof power, "e%d", d->exponent);
    int scientific = d->count + (d->count > 1) + power_length;
    int fixed;
    if (d->exponent < 0)
        fixed = 1 - d->exponent + d->count;
    else
        fixed = d->count > d->exponent + 1 ? d->count + 1 : d->exponent + 1;
    bool whole = d->exponent >= 0 && d->count <= d->exponent + 1;

    char *p = text;
    if (negative)
        *p++ = '-';
    if (fixed > scientific && !(whole && d->exponent < 7)) {
        *p++ = d->digits[0];
        if (d->count > 1)
            *p++ = '.';
        memcpy(p, d->digits + 1, (size_t)(d->count - 1));
        p += d->count - 1;
        memcpy(p, power, (size_t)power_length + 1);
        return text;
    }
    if (d->exponent < 0) {
        *p++ = '0';
        *p++ = '.';
        for (int i = -1; i > d->exponent; i--)
            *p++ = '0';
        memcpy(p, d->digits, (size_t)d->count);
        p += d->count;
    } else {
        int length = whole ? d->exponent + 1 : d->count;
        for (int i = 0; i < length; i++) {
            if (i == d->exponent + 1)
                *p++ = '.';
            *p++ = i < d->count ? d->digits[i] : '0';
        }
    }
    *p = '\0';
    return text;
}

static char *special(double value, char text[BASE_NUMBER_SIZE])
{
    const char *name = isnan(value)   ? "nan"
                       : isinf(value) ? (value > 0.0 ? "inf" : "-inf")
                                      : (signbit(value) ? "-0" : "0");
    return strcpy(text, name);
}

char *base_shortest_f64(double value, char text[BASE_NUMBER_SIZE])
{
    if (!isfinite(value) || value == 0.0)
        return special(value, text);
    double magnitude = fabs(value);
    decimal d;
    locale_t before = base_enter_c_locale();
    if (!isnormal(value) || !quick_digits(&d, magnitude, 15, 17, 53))
        shortest_digits(&d, magnitude, &magnitude, reads_back_f64, 15, 17, !isnormal(value));
    base_leave_c_locale(before);
    return write_decimal(&d, value < 0.0, text);
}

char *base_shortest_f32(float value, char text[BASE_NUMBER_SIZE])
{
    if (!isfinite(value) || value == 0.0f)
        return special((double)value, text);
    float magnitude = fabsf(value);
    decimal d;
    locale_t before = base_enter_c_locale();
    if (!isnormal(value) || !quick_digits(&d, (double)magnitude, 6, 9, 24))
        shortest_digits(&d, (double)magnitude, &magnitude, reads_back_f32, 6, 9, !isnormal(value));
    base_leave_c_locale(before);
    return write_decimal(&d, value < 0.0f, text);
}

void base_error(const char *format, ...)
{
    char line[2048] = "sgfit: ";
    size_t prefix = strlen(line);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line + prefix, sizeof line - prefix - 1, format, arguments);
    va_end(arguments);
    /* One line whatever a file name or a field contains. */
    for (char *p = line; *p; p++)
        if ((unsigned char)*p < 0x20 || *p == 0x7f)
            *p = '?';
    strcat(line, "\n");
    fputs(line, stderr);
}
