/* text.h: numbers as text and back, independent of locale; one-line diagnostics. */
#ifndef BASE_TEXT_H
#define BASE_TEXT_H

#include <stdbool.h>
#include <stddef.h>

enum { BASE_NUMBER_SIZE = 40 };

/* The shortest decimal text that reads back to the same double (float), always with a point where
 * a digit needs one; inf, -inf and nan as such. Returns text. */
char *base_shortest_f64(double value, char text[BASE_NUMBER_SIZE]);
char *base_shortest_f32(float value, char text[BASE_NUMBER_SIZE]);

/* Reads the whole of text[0..length) as one number (surrounding blanks allowed, "inf" and "nan"
 * understood). False where it is anything else. */
bool base_parse_f64(const char *text, size_t length, double *value);
bool base_parse_long(const char *text, long *value);

/* One line "sgfit: ..." on standard error. */
void base_error(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
