/* cost_subjects.c: what is measured, with the text that it is measured by. */
#include "cost.h"

#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"
#include "tables/emit.h"

const char *cost_quantity_name(sg_quantity quantity)
{
    return quantity == SG_L ? "L" : "A_h";
}

/* The include with that method alone, and f calling it. NULL after one line. */
static char *method_text(const form_list *forms, const method_list *methods, const char *id,
                         sg_quantity quantity)
{
    const method *only = methods_find(methods, id);
    if (!only) {
        base_error("tables/constants: expected %s.json, which this program was built with", id);
        return NULL;
    }
    buffer text = {0};
    if (!emit_glsl(&text, forms, methods, only, "", "", only)) {
        buffer_free(&text);
        return NULL;
    }
    buffer_print(&text,
                 "float f(float lambda, float cos_theta)\n{\n    return sg_%s_%s(lambda, "
                 "cos_theta);\n}\n",
                 cost_quantity_name(quantity), id);
    return text.text;
}

static void add(cost_subjects *subjects, cost_subject subject)
{
    subjects->list =
        base_reallocate(subjects->list, (subjects->count + 1) * sizeof *subjects->list);
    subjects->list[subjects->count++] = subject;
}

static bool add_methods(cost_subjects *subjects, const form_list *forms, const method_list *methods,
                        const char *only)
{
    static const sg_quantity quantities[] = {SG_L, SG_A_H};
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *method = sg_method_at(i);
        if (only && strcmp(only, method->id) != 0)
            continue;
        for (int j = 0; j < 2; j++) {
            char *glsl = method_text(forms, methods, method->id, quantities[j]);
            if (!glsl)
                return false;
            cost_subject subject = {.id = base_copy(method->id, strlen(method->id)),
                                    .quantity = quantities[j],
                                    .method = method,
                                    .glsl = glsl};
            if (strcmp(method->variant, "published") == 0) {
                subject.include = glsl;
                subject.glsl = cost_as_shipped(glsl);
            }
            add(subjects, subject);
            if (!subject.glsl)
                return false;
        }
    }
    return true;
}

static bool add_tables(cost_subjects *subjects, const form_list *forms, const char *only)
{
    static const sg_quantity quantities[] = {SG_L, SG_A_H};
    for (size_t i = 0; i < cost_table_count(); i++) {
        if (only && strcmp(only, cost_table_id(i)) != 0)
            continue;
        for (int j = 0; j < 2; j++) {
            cost_subject subject;
            if (!cost_table_subject(i, forms, quantities[j], &subject))
                return false;
            add(subjects, subject);
        }
    }
    return true;
}

bool cost_subjects_read(cost_subjects *subjects, const char *only)
{
    *subjects = (cost_subjects){0};
    form_list forms = {0};
    method_list methods = {0};
    char *form_folder = base_join(base_source_root(), "shaders/forms");
    char *constants = base_join(base_source_root(), "tables/constants");
    bool good = forms_read(&forms, form_folder) && methods_read(&methods, constants, &forms) &&
                add_methods(subjects, &forms, &methods, only) && add_tables(subjects, &forms, only);
    free(form_folder);
    free(constants);
    methods_free(&methods);
    forms_free(&forms);
    if (good && subjects->count == 0) {
        base_error("expected the id of a method (see sgfit methods) or of a table, found %s", only);
        good = false;
    }
    if (!good)
        cost_subjects_free(subjects);
    return good;
}

void cost_subjects_free(cost_subjects *subjects)
{
    for (size_t i = 0; i < subjects->count; i++) {
        free(subjects->list[i].id);
        free(subjects->list[i].glsl);
        free(subjects->list[i].include);
        free(subjects->list[i].texture.texels);
    }
    free(subjects->list);
    *subjects = (cost_subjects){0};
}
