/* The built-in shaders, and the same compiled again for another method of the registry. */
#include "render.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "base/buffer.h"
#include "shader_table.h"
#include "shaders.h"

enum { TABLE_SIZE = sizeof shader_table / sizeof *shader_table, MOST_NESTED = 8 };

static int find(const char *path, size_t length)
{
    for (int i = 0; i < TABLE_SIZE; i++)
        if (strlen(shader_table[i].path) == length &&
            memcmp(shader_table[i].path, path, length) == 0)
            return i;
    return -1;
}

gpu_shader render_shader(const char *path)
{
    int i = find(path, strlen(path));
    if (i < 0)
        return (gpu_shader){NULL, NULL, 0};
    return (gpu_shader){NULL, shader_table[i].words, shader_table[i].word_count};
}

const char *render_shader_path(int index)
{
    return index >= 0 && index < TABLE_SIZE ? shader_table[index].path : NULL;
}

/* ---- Splicing ---------------------------------------------------------------------------------
 */

/* Index of the file that a line of the given file includes: the text between the quotes, relative
 * to the folder of the file. */
static int included(const char *from, const char *name, size_t length)
{
    char path[256];
    const char *slash = strrchr(from, '/');
    int folder = slash ? (int)(slash - from) : 0;
    while (length > 3 && memcmp(name, "../", 3) == 0) {
        name += 3;
        length -= 3;
        while (folder > 0 && from[--folder] != '/')
            ;
    }
    int size = snprintf(path, sizeof path, "%.*s%s%.*s", folder, from, folder ? "/" : "",
                        (int)length, name);
    return size > 0 && size < (int)sizeof path ? find(path, (size_t)size) : -1;
}

/* Copies a file line by line, with the files that it includes in the place of their lines (each
 * guards itself against being there twice), and what is to be defined after its first line. */
static bool splice(int file, const char *define, int depth, buffer *out)
{
    static const char include[] = "#include \"";
    const char *at = (const char *)shader_table[file].text;
    const char *end = at + shader_table[file].length;
    while (at < end) {
        const char *line_end = memchr(at, '\n', (size_t)(end - at));
        line_end = line_end ? line_end + 1 : end;
        size_t length = (size_t)(line_end - at);
        bool done = true;
        if (length > sizeof include && memcmp(at, include, sizeof include - 1) == 0) {
            const char *name = at + sizeof include - 1;
            const char *quote = memchr(name, '"', (size_t)(line_end - name));
            int other =
                quote ? included(shader_table[file].path, name, (size_t)(quote - name)) : -1;
            done = other >= 0 && depth < MOST_NESTED && splice(other, "", depth + 1, out);
        } else {
            buffer_add_n(out, at, length);
        }
        if (!done)
            return false;
        buffer_add(out, define);
        define = "";
        at = line_end;
    }
    return true;
}

gpu_status render_shader_method(const char *path, const char *method, gpu_shader *shader)
{
    *shader = (gpu_shader){NULL, NULL, 0};
    int file = find(path, strlen(path));
    if (file < 0)
        return gpu_fail(GPU_BAD_SHADER, "%s: there is no such shader", path);
    char define[192];
    const char *name = method ? method : "standard";
    int length =
        snprintf(define, sizeof define,
                 "#define SG_METHOD_A_h sg_A_h_%s\n#define SG_METHOD_L sg_L_%s\n", name, name);
    if (length < 0 || length >= (int)sizeof define)
        return gpu_fail(GPU_BAD_SHADER, "%s: the method's name is too long", path);
    buffer spliced = {NULL, 0, 0};
    if (!splice(file, define, 0, &spliced)) {
        buffer_free(&spliced);
        return gpu_fail(GPU_BAD_SHADER, "%s: an include is missing or nested too deeply", path);
    }
    shader->source = spliced.text;
    return GPU_OK;
}
