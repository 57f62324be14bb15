/* page.c: see page.h. */
#define _POSIX_C_SOURCE 200809L
#include "page.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"
#include "html.h"

typedef struct bytes {
    char *name, *data;
    size_t size;
} bytes;

/* Streams into memory; open_memstream keeps text and size up to date on flush. */
typedef struct memory {
    FILE *stream;
    char *text;
    size_t size;
} memory;

struct page {
    const char *title, *lead;
    memory body, navigation, style, script, open;
    const char *open_name;
    size_t sections, files, capacity;
    bytes *file;
};

static void *needed(void *pointer)
{
    if (!pointer) {
        base_error("out of memory while writing the report");
        abort();
    }
    return pointer;
}

static void open_memory(memory *m)
{
    m->stream = needed(open_memstream(&m->text, &m->size));
}

static void close_memory(memory *m)
{
    if (m->stream)
        fclose(m->stream);
    free(m->text);
}

page *page_new(const char *title, const char *lead)
{
    page *p = needed(calloc(1, sizeof *p));
    p->title = title;
    p->lead = lead;
    open_memory(&p->body);
    open_memory(&p->navigation);
    open_memory(&p->style);
    open_memory(&p->script);
    return p;
}

void page_free(page *page)
{
    if (!page)
        return;
    close_memory(&page->body);
    close_memory(&page->navigation);
    close_memory(&page->style);
    close_memory(&page->script);
    close_memory(&page->open);
    for (size_t i = 0; i < page->files; i++) {
        free(page->file[i].name);
        free(page->file[i].data);
    }
    free(page->file);
    free(page);
}

void page_section(page *page, const char *id, const char *title)
{
    FILE *nav = page->navigation.stream;
    fprintf(nav, "<li><a href=\"#%s\">", id);
    html_text(nav, title);
    fputs("</a></li>\n", nav);
    FILE *out = page->body.stream;
    if (page->sections++)
        fputs("</section>\n", out);
    fprintf(out, "<section id=\"%s\">\n<h2>", id);
    html_text(out, title);
    fputs("</h2>\n", out);
}

FILE *page_html(page *page)
{
    return page->body.stream;
}

void page_file(page *page, const char *name, const char *data, size_t size)
{
    if (page->files == page->capacity) {
        page->capacity = page->capacity ? 2 * page->capacity : 16;
        page->file = needed(realloc(page->file, page->capacity * sizeof *page->file));
    }
    bytes *file = &page->file[page->files++];
    file->name = needed(strdup(name));
    file->data = needed(malloc(size + 1));
    memcpy(file->data, data, size);
    file->size = size;
}

FILE *page_file_begin(page *page, const char *name)
{
    open_memory(&page->open);
    page->open_name = name;
    return page->open.stream;
}

void page_file_end(page *page)
{
    fflush(page->open.stream);
    page_file(page, page->open_name, page->open.text, page->open.size);
    close_memory(&page->open);
    page->open = (memory){0};
}

void page_style(page *page, const char *text, size_t size)
{
    fwrite(text, 1, size, page->style.stream);
}

void page_script(page *page, const char *text, size_t size)
{
    fwrite(text, 1, size, page->script.stream);
}

static void put(FILE *out, memory *m)
{
    fflush(m->stream);
    fwrite(m->text, 1, m->size, out);
}

static void write_index(page *page, FILE *out)
{
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
          "<meta name=\"color-scheme\" content=\"light dark\">\n<title>",
          out);
    html_text(out, page->title);
    fputs("</title>\n<style>\n", out);
    put(out, &page->style);
    fputs("</style>\n</head>\n<body>\n<header>\n<h1>", out);
    html_text(out, page->title);
    fputs("</h1>\n<p>", out);
    html_text(out, page->lead);
    fputs("</p>\n</header>\n<nav aria-label=\"Sections\">\n<ul>\n", out);
    put(out, &page->navigation);
    fputs("</ul>\n</nav>\n<main>\n", out);
    put(out, &page->body);
    if (page->sections)
        fputs("</section>\n", out);
    fputs("</main>\n", out);
    fflush(page->script.stream);
    if (page->script.size) {
        fputs("<script>\n", out);
        put(out, &page->script);
        fputs("</script>\n", out);
    }
    fputs("</body>\n</html>\n", out);
}

/* Opens the output and hands all of its bytes to the system, but does not put it into place. */
static bool begin_one(base_output *output, const char *folder, const char *name, const char *data,
                      size_t size)
{
    char *path = base_join(folder, name);
    char *slash = strrchr(path, '/');
    *slash = '\0';
    bool done = base_make_directory(path);
    *slash = '/';
    done = done && base_output_open(output, path);
    if (done && (fwrite(data, 1, size, output->stream) != size || fflush(output->stream) != 0)) {
        base_error("%s: cannot be written: %s", path, strerror(errno));
        base_output_discard(output);
        done = false;
    }
    free(path);
    return done;
}

/* All files are written beside their places first and put there after the last one stood: a disk
 * that fills up leaves an earlier report as it was. */
bool page_write(page *page, const char *folder, const char *index_name)
{
    memory index = {0};
    open_memory(&index);
    write_index(page, index.stream);
    fflush(index.stream);
    base_output *outputs = needed(calloc(page->files + 1, sizeof *outputs));
    size_t begun = 0;
    bool done = true;
    while (done && begun <= page->files) {
        bool last = begun == page->files;
        const bytes *file = last ? NULL : &page->file[begun];
        done = last ? begin_one(&outputs[begun], folder, index_name, index.text, index.size)
                    : begin_one(&outputs[begun], folder, file->name, file->data, file->size);
        begun += done;
    }
    for (size_t i = 0; i < begun; i++) {
        if (done)
            done = base_output_close(&outputs[i]);
        else
            base_output_discard(&outputs[i]);
    }
    free(outputs);
    close_memory(&index);
    return done;
}
