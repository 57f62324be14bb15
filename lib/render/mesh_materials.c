/* mesh_materials.c: albedos from a table beside the mesh. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/text.h"
#include "mesh_private.h"

enum { MOST_COLUMNS = 64 };

/* Splits the line at *next at its tabs, ends fields with NUL and moves on; the number of fields. */
static int split(char **next, char *fields[MOST_COLUMNS])
{
    char *line = *next, *end = line + strcspn(line, "\n");
    *next = *end ? end + 1 : end;
    if (end > line && end[-1] == '\r')
        end[-1] = '\0';
    *end = '\0';
    int count = 0;
    while (line && count < MOST_COLUMNS) {
        fields[count++] = line;
        line = strchr(line, '\t');
        if (line)
            *line++ = '\0';
    }
    return count;
}

static bool find_columns(char **next, const char *path, int columns[3])
{
    static const char *const names[] = {"mean_linear_albedo_r", "g", "b"};
    char *fields[MOST_COLUMNS];
    int count = split(next, fields);
    for (int c = 0; c < 3; c++) {
        columns[c] = -1;
        for (int f = 0; f < count; f++)
            if (strcmp(fields[f], names[c]) == 0)
                columns[c] = f;
        if (columns[c] < 0) {
            base_error("%s, line 1: expected a column \"%s\"", path, names[c]);
            return false;
        }
    }
    return true;
}

static bool read_table(char *text, const char *path, mesh *result)
{
    int columns[3];
    if (!find_columns(&text, path, columns))
        return false;
    char *fields[MOST_COLUMNS];
    for (size_t row = 0; *text; row++) {
        int count = split(&text, fields);
        if (row >= result->material_count) {
            base_error("%s, line %zu: expected no more than the mesh's %zu materials", path,
                       row + 2, result->material_count);
            return false;
        }
        for (int c = 0; c < 3; c++) {
            double value;
            const char *field = columns[c] < count ? fields[columns[c]] : "";
            if (!base_parse_f64(field, strlen(field), &value) || !(value >= 0 && value <= 1)) {
                base_error("%s, line %zu: expected an albedo in [0, 1], found \"%.40s\"", path,
                           row + 2, field);
                return false;
            }
            result->albedos[3 * row + (size_t)c] = (float)value;
        }
    }
    return true;
}

bool mesh_read_materials(const char *path, mesh *result)
{
    const char *dot = strrchr(path, '.');
    buffer name = {0};
    buffer_add_n(&name, path, dot ? (size_t)(dot - path) : strlen(path));
    buffer_add(&name, ".materials.tsv");
    bool good = true;
    if (access(name.text, F_OK) == 0) {
        char *text = base_read_file(name.text, NULL);
        good = text && read_table(text, name.text, result);
        free(text);
    }
    buffer_free(&name);
    return good;
}
