/* report_tried.c: the section "What was tried": bench/tried.md and those of its
 * kind, whose Markdown is headings, lists, tables shown as they are, and paragraphs. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/file.h"
#include "html.h"
#include "report.h"

typedef enum block { NOTHING, PARAGRAPH, LIST, VERBATIM } block;

static const char *const files[] = {"bench/tried.md", "bench/hull_tried.md",
                                    "bench/rivals_tried.md", "bench/multires_tried.md",
                                    "bench/lpv_tried.md"};
enum { FILES = sizeof files / sizeof *files };

static char *tried_path(size_t file)
{
    return base_join(base_source_root(), files[file]);
}

bool report_has_tried(const report *report)
{
    (void)report;
    bool there = true;
    for (size_t i = 0; i < FILES && there; i++) {
        char *path = tried_path(i);
        there = access(path, R_OK) == 0;
        free(path);
    }
    return there;
}

static void turn(FILE *out, block *now, block next)
{
    static const char *const open[] = {"", "<p>", "<ul>\n", "<pre>"};
    static const char *const close[] = {"", "</p>\n", "</ul>\n", "</pre>\n"};
    if (*now == next)
        return;
    fputs(close[*now], out);
    fputs(open[next], out);
    *now = next;
}

/* List items are closed where the next begins, so that they may go on over several lines. */
static void write_line(FILE *out, block *now, bool *item, const char *line)
{
    bool bullet = strncmp(line + strspn(line, " "), "- ", 2) == 0;
    bool more = *item && line[0] == ' ' && !bullet;
    if (*item && !more) {
        fputs("</li>\n", out);
        *item = false;
    }
    if (line[strspn(line, " ")] == '\0') {
        turn(out, now, NOTHING);
    } else if (line[0] == '#') {
        turn(out, now, NOTHING);
        line += strspn(line, "#");
        fputs("<h3>", out);
        html_text(out, line + strspn(line, " "));
        fputs("</h3>\n", out);
    } else if (bullet) {
        turn(out, now, LIST);
        fputs("<li>", out);
        html_text(out, line + strspn(line, " ") + 2);
        *item = true;
    } else if (more) {
        html_text(out, line);
    } else {
        turn(out, now, line[0] == '|' || strncmp(line, "    ", 4) == 0 ? VERBATIM : PARAGRAPH);
        html_text(out, line);
        fputc('\n', out);
    }
}

static bool write_file(FILE *out, size_t file)
{
    char *path = tried_path(file), *text = base_read_file(path, NULL);
    free(path);
    if (!text)
        return false;
    block now = NOTHING;
    bool item = false;
    for (char *line = text; *line;) {
        size_t length = strcspn(line, "\n");
        bool last = line[length] == '\0';
        line[length] = '\0';
        write_line(out, &now, &item, line);
        line += length + !last;
        if (last)
            break;
    }
    write_line(out, &now, &item, "");
    free(text);
    return true;
}

bool report_tried(report *report)
{
    bool good = true;
    for (size_t i = 0; i < FILES && good; i++)
        good = write_file(page_html(report->page), i);
    return good;
}
