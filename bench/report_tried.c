/* report_tried.c: the section "What was tried": bench/tried.md, whose Markdown is headings, lists,
 * tables shown as they are, and paragraphs. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/file.h"
#include "html.h"
#include "report.h"

typedef enum block { NOTHING, PARAGRAPH, LIST, VERBATIM } block;

static char *tried_path(void)
{
    return base_join(base_source_root(), "bench/tried.md");
}

bool report_has_tried(const report *report)
{
    (void)report;
    char *path = tried_path();
    bool there = access(path, R_OK) == 0;
    free(path);
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

bool report_tried(report *report)
{
    char *path = tried_path(), *text = base_read_file(path, NULL);
    free(path);
    if (!text)
        return false;
    FILE *out = page_html(report->page);
    block now = NOTHING;
    bool item = false, title = true;
    for (char *line = text; *line;) {
        size_t length = strcspn(line, "\n");
        bool last = line[length] == '\0';
        line[length] = '\0';
        if (!title || strncmp(line, "# ", 2) != 0) /* the section has a title */
            write_line(out, &now, &item, line);
        title = false;
        line += length + !last;
        if (last)
            break;
    }
    write_line(out, &now, &item, "");
    free(text);
    return true;
}
