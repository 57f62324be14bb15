/* html.h: escaping, paragraphs, tables and numbers for the report's pages. */
#ifndef BENCH_HTML_H
#define BENCH_HTML_H

#include <stdarg.h>
#include <stdio.h>

#include "page.h"

/* Escaped text; `quoted` parts become <code>. */
void html_text(FILE *out, const char *text);
/* The same of formatted text, of up to 4095 characters. */
void html_formatted(FILE *out, const char *format, va_list arguments)
    __attribute__((format(printf, 2, 0)));
/* A paragraph of formatted, then escaped text. */
void html_paragraph(page *page, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A number for people: `digits` significant digits, 1.28e-3 rather than 1.28e-03. */
enum { HTML_NUMBER_SIZE = 48 };
char *html_number(double value, int digits, char text[HTML_NUMBER_SIZE]);

/* A table that scrolls inside its own box. columns: names, NULL-ended; a name that begins with
 * '#' is a column of numbers (aligned right); none at all: a table without a head. */
void html_table_begin(page *page, const char *caption, const char *const *columns);
void html_row_begin(page *page, const char *css_class); /* class may be NULL */
void html_cell(page *page, const char *text);
void html_cell_wrap(page *page, const char *text); /* a sentence: may take several lines */
void html_cell_code(page *page, const char *text);
void html_cell_number(page *page, double value, int digits);
/* As html_cell_number, with a class and a tooltip (either may be NULL). */
void html_cell_marked(page *page, double value, int digits, const char *css_class,
                      const char *tooltip);
void html_row_end(page *page);
/* csv: the file with the same numbers, linked below the table; may be NULL. */
void html_table_end(page *page, const char *csv);

#endif
