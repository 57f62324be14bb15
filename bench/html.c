/* html.c: see html.h. */
#define _POSIX_C_SOURCE 200809L
#include "html.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

void html_text(FILE *out, const char *text)
{
    bool code = false;
    for (; *text; text++) {
        switch (*text) {
        case '&':
            fputs("&amp;", out);
            break;
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        case '"':
            fputs("&quot;", out);
            break;
        case '`':
            fputs(code ? "</code>" : "<code>", out);
            code = !code;
            break;
        default:
            fputc(*text, out);
        }
    }
    if (code)
        fputs("</code>", out);
}

void html_formatted(FILE *out, const char *format, va_list arguments)
{
    char text[4096];
    vsnprintf(text, sizeof text, format, arguments);
    html_text(out, text);
}

void html_paragraph(page *page, const char *format, ...)
{
    FILE *out = page_html(page);
    va_list arguments;
    va_start(arguments, format);
    fputs("<p>", out);
    html_formatted(out, format, arguments);
    fputs("</p>\n", out);
    va_end(arguments);
}

char *html_number(double value, int digits, char text[HTML_NUMBER_SIZE])
{
    if (isnan(value))
        return strcpy(text, "NaN");
    if (isinf(value))
        return strcpy(text, value > 0 ? "∞" : "−∞");
    double size = fabs(value);
    if (size == 0.0)
        return strcpy(text, "0");
    if (size >= 1e-2 && size < 1e5) {
        int before = (int)floor(log10(size)) + 1;
        int decimals = digits - before;
        snprintf(text, HTML_NUMBER_SIZE, "%.*f", decimals > 0 ? decimals : 0, value);
        return text;
    }
    snprintf(text, HTML_NUMBER_SIZE, "%.*e", digits - 1, value);
    /* e-03 to e-3: drop the plus sign and the zeros before the exponent's first digit */
    char *to = strchr(text, 'e') + 1, *from = to;
    if (*from == '-')
        to++;
    from++;
    from += strspn(from, "0");
    memmove(to, from, strlen(from) + 1);
    return text;
}

void html_table_begin(page *page, const char *caption, const char *const *columns)
{
    FILE *out = page_html(page);
    fputs("<figure class=\"table\">\n<figcaption>", out);
    html_text(out, caption);
    fputs("</figcaption>\n<div class=\"scroll\" tabindex=\"0\"><table>\n", out);
    if (!*columns) { /* without a head */
        fputs("<tbody>\n", out);
        return;
    }
    fputs("<thead><tr>", out);
    for (; *columns; columns++) {
        bool number = **columns == '#';
        fputs(number ? "<th class=\"n\">" : "<th>", out);
        html_text(out, *columns + number);
        fputs("</th>", out);
    }
    fputs("</tr></thead>\n<tbody>\n", out);
}

void html_row_begin(page *page, const char *css_class)
{
    if (css_class)
        fprintf(page_html(page), "<tr class=\"%s\">", css_class);
    else
        fputs("<tr>", page_html(page));
}

void html_cell(page *page, const char *text)
{
    FILE *out = page_html(page);
    fputs("<td>", out);
    html_text(out, text);
    fputs("</td>", out);
}

void html_cell_wrap(page *page, const char *text)
{
    FILE *out = page_html(page);
    fputs("<td class=\"wrap\">", out);
    html_text(out, text);
    fputs("</td>", out);
}

void html_cell_code(page *page, const char *text)
{
    FILE *out = page_html(page);
    fputs("<td><code>", out);
    html_text(out, text);
    fputs("</code></td>", out);
}

void html_cell_marked(page *page, double value, int digits, const char *css_class,
                      const char *tooltip)
{
    char text[HTML_NUMBER_SIZE];
    FILE *out = page_html(page);
    fprintf(out, "<td class=\"n%s%s\"", css_class ? " " : "", css_class ? css_class : "");
    if (tooltip) {
        fputs(" title=\"", out);
        html_text(out, tooltip);
        fputs("\"", out);
    }
    fprintf(out, ">%s</td>", html_number(value, digits, text));
}

void html_cell_number(page *page, double value, int digits)
{
    html_cell_marked(page, value, digits, NULL, NULL);
}

void html_row_end(page *page)
{
    fputs("</tr>\n", page_html(page));
}

void html_table_end(page *page, const char *csv)
{
    FILE *out = page_html(page);
    fputs("</tbody></table></div>\n", out);
    if (csv)
        fprintf(out, "<p class=\"source\"><a href=\"%s\">%s</a></p>\n", csv, csv);
    fputs("</figure>\n", out);
}
