/* emit.c: the command. */
#include "emit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/options.h"
#include "base/text.h"
#include "curves.h"
#include "lut.h"
#include "tables.h"

typedef struct sources {
    form_list forms;
    method_list methods;
    char *lobe_path, *lobe;
    char *table_path, *table;
    const method *irradiance; /* that sg_irradiance uses where all methods are written */
} sources;

/* The method named by lobe.glsl in a line "// method: ID". */
static bool find_irradiance(sources *from)
{
    const char *line = strstr(from->lobe, "// method: ");
    char id[128] = "";
    if (!line || sscanf(line, "// method: %127s", id) != 1 ||
        !(from->irradiance = methods_find(&from->methods, id))) {
        base_error("%s:1: expected a line \"// method: ID\" that names a method, the one that "
                   "sg_irradiance uses",
                   from->lobe_path);
        return false;
    }
    return true;
}

/* Whatever the writers could refuse is refused here, before anything is written. */
static bool can_be_written(const sources *from)
{
    buffer trial = {0};
    bool good = emit_glsl(&trial, &from->forms, &from->methods, NULL, from->lobe_path, from->lobe,
                          from->irradiance) &&
                emit_table_glsl(&trial, &from->forms, from->table_path, from->table);
    buffer_free(&trial);
    return good;
}

static bool read_sources(sources *from, const char *root, const char *tables)
{
    char *forms = base_join(root, "shaders/forms"), *constants = base_join(tables, "constants");
    char *cost = base_join(tables, "cost.csv");
    *from = (sources){.lobe_path = base_join(forms, "lobe.glsl"),
                      .table_path = base_join(forms, "table.glsl")};
    bool good = forms_read(&from->forms, forms) &&
                methods_read(&from->methods, constants, &from->forms) &&
                methods_read_costs(&from->methods, cost) &&
                (from->lobe = base_read_file(from->lobe_path, NULL)) &&
                (from->table = base_read_file(from->table_path, NULL)) && find_irradiance(from) &&
                can_be_written(from);
    free(forms);
    free(constants);
    free(cost);
    return good;
}

static void free_sources(sources *from)
{
    methods_free(&from->methods);
    forms_free(&from->forms);
    free(from->lobe_path);
    free(from->lobe);
    free(from->table_path);
    free(from->table);
}

/* Writes folder/name and empties the text. */
static bool write_out(buffer *text, const char *folder, const char *name)
{
    char *path = base_join(folder, name);
    bool good = base_write_file(path, text->text, text->length);
    free(path);
    buffer_free(text);
    return good;
}

static bool write_shader(const sources *from, const char *path, const method *only)
{
    buffer text = {0};
    bool good = emit_glsl(&text, &from->forms, &from->methods, only, from->lobe_path, from->lobe,
                          only ? only : from->irradiance);
    good = good && base_write_file(path, text.text, text.length);
    buffer_free(&text);
    return good;
}

/* What follows from the forms and constants alone: all made before the first is written. */
static bool write_texts(const sources *from, const char *out, const char *shaders)
{
    enum { FORMS, METHODS, REGISTRY, SHADER, TABLE, TEXTS };
    static const char *const names[TEXTS] = {"forms.inc", "methods.inc", "registry.inc", "sg.glsl",
                                             "sg_table.glsl"};
    buffer texts[TEXTS] = {{0}};
    emit_forms_inc(&texts[FORMS], &from->forms);
    emit_methods_inc(&texts[METHODS], &from->methods);
    emit_registry_inc(&texts[REGISTRY], &from->forms, &from->methods);
    bool good = emit_glsl(&texts[SHADER], &from->forms, &from->methods, NULL, from->lobe_path,
                          from->lobe, from->irradiance) &&
                emit_table_glsl(&texts[TABLE], &from->forms, from->table_path, from->table);
    for (int i = 0; i < TEXTS; i++) {
        if (good)
            good = write_out(&texts[i], i < SHADER ? out : shaders, names[i]);
        buffer_free(&texts[i]);
    }
    return good;
}

/* What follows from the integral. */
static bool write_tables(const char *out)
{
    buffer text = {0};
    lut made;
    curves_c_s(&text);
    bool good = write_out(&text, out, "curves_c_s.csv");
    good = curves_t_u(&text) && write_out(&text, out, "curves_t_u.csv") && good;
    buffer_free(&text);
    good = lut_make(&made) && write_out(&made.float_exr, out, "tail_32_float.exr") &&
           write_out(&made.half_exr, out, "tail_32_half.exr") &&
           write_out(&made.readme, out, "README.md") && good;
    lut_free(&made);
    return good;
}

static bool write_all(const sources *from, const char *root)
{
    char *out = base_join(root, "tables/out"), *shaders = base_join(root, "shaders");
    bool good = base_make_directory(out) && base_make_directory(shaders) &&
                write_texts(from, out, shaders) && write_tables(out);
    free(out);
    free(shaders);
    return good;
}

static int emit(int argc, char **argv)
{
    const char *out = NULL, *id = NULL, *root = NULL, *tables = NULL, *all_to = NULL;
    const base_usage usage = {
        "emit", "[options]",
        "Writes what is generated from tables/constants, tables/cost.csv and shaders/forms (the C "
        "instances tables/out/*.inc and the shader includes shaders/sg.glsl and sg_table.glsl) and "
        "from the integral (the curves and the look-up table in tables/out). Without --out all of "
        "them, into the source tree or into the folder given by --all-to, laid out alike."};
    const base_option options[] = {
        {"out", BASE_STRING, &out, "FILE", "write the shader include alone, to FILE", NULL},
        {"method", BASE_STRING, &id, "ID",
         "with --out: this method alone and what it needs; sg_irradiance uses it", NULL},
        {"all-to", BASE_STRING, &all_to, "DIR", "write everything below DIR instead", NULL},
        {"root", BASE_STRING, &root, "DIR", "the source tree (default: where this was built from)",
         NULL},
        {"tables", BASE_STRING, &tables, "DIR",
         "the folder with constants/ and cost.csv (default: tables of the source tree)", NULL}};
    int status =
        base_parse_options(argc, argv, &usage, options, sizeof options / sizeof options[0], NULL);
    if (status >= 0)
        return status;
    if (out && all_to) {
        base_error("emit: expected --out or --all-to, not both");
        return BASE_USAGE;
    }
    if (id && !out) {
        base_error("emit: expected --out FILE with --method");
        return BASE_USAGE;
    }
    if (!root)
        root = base_source_root();
    char *default_tables = base_join(root, "tables");
    sources from;
    const method *only = NULL;
    status = BASE_USAGE;
    bool read = read_sources(&from, root, tables ? tables : default_tables);
    if (read && id && !(only = methods_find(&from.methods, id)))
        base_error("emit: expected --method to name a method (see sgfit methods), found %s", id);
    else if (read && out)
        status = write_shader(&from, out, only) ? BASE_DONE : BASE_FAILED;
    else if (read)
        status = write_all(&from, all_to ? all_to : root) ? BASE_DONE : BASE_FAILED;
    free_sources(&from);
    free(default_tables);
    return status;
}

const base_command tables_commands[] = {
    {"emit", "writes the drop-in shader include and the tables", emit}, {NULL, NULL, NULL}};
