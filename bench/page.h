/* page.h: one self-contained HTML page and the files beside it, kept in memory until all of it is
 * there, then written at once. */
#ifndef BENCH_PAGE_H
#define BENCH_PAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct page page;

page *page_new(const char *title, const char *lead);
void page_free(page *page);

/* Opens a section; it ends where the next begins. The navigation is made from these. */
void page_section(page *page, const char *id, const char *title);
/* The body so far, to write to; what is written here must be escaped (html.h). */
FILE *page_html(page *page);

/* A file to stand beside the page, name relative to it ("data/x.csv"); the bytes are copied. */
void page_file(page *page, const char *name, const char *bytes, size_t size);

/* The same, written to a stream: one at a time, from begin to end. */
FILE *page_file_begin(page *page, const char *name);
void page_file_end(page *page);

/* Text that goes into the page's style sheet or script as it is, once each. */
void page_style(page *page, const char *text, size_t size);
void page_script(page *page, const char *text, size_t size);

/* Writes everything into folder, the page as index_name and the files beside it: all of them, or,
 * where one cannot be written, none. False after one line. */
bool page_write(page *page, const char *folder, const char *index_name);

#endif
