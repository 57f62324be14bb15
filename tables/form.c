/* form.c: the folder of texts: files, their comment headers, the order of the helpers. */
#include "form.h"

#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"

/* Plain GLSL, not formulas: see emit_glsl.c. */
static bool is_formula(const char *name)
{
    return strcmp(name, "lobe.glsl") != 0 && strcmp(name, "table.glsl") != 0;
}

static char **words(const char *text, size_t *count)
{
    char **list = NULL;
    *count = 0;
    for (text += strspn(text, " "); *text; text += strspn(text, " ")) {
        size_t length = strcspn(text, " ");
        list = base_reallocate(list, (*count + 1) * sizeof *list);
        list[(*count)++] = base_copy(text, length);
        text += length;
    }
    return list;
}

/* One comment line; true where it was one of the known keys or free text. */
static void header_line(form *text, const char *line, size_t length, bool first, buffer *notes)
{
    static const char *const keys[] = {"computes:", "coefficients:", "source:", "double:"};
    size_t key = 0;
    while (key < 4 && strncmp(line, keys[key], strlen(keys[key])) != 0)
        key++;
    if (key < 4) {
        line += strlen(keys[key]);
        length -= strlen(keys[key]);
        while (length && *line == ' ') {
            line++;
            length--;
        }
    }
    char *value = base_copy(line, length);
    char **place = key == 0 ? &text->computes : key == 2 ? &text->source : &text->c_double;
    size_t id = strlen(text->id);
    if (key == 1) {
        /* A second line of this kind replaces the first. */
        for (size_t i = 0; i < text->coefficient_count; i++)
            free(text->coefficients[i]);
        free(text->coefficients);
        text->coefficients = words(value, &text->coefficient_count);
        free(value);
    } else if (key < 4) {
        free(*place);
        *place = value;
    } else if (first && strncmp(value, text->id, id) == 0 && value[id] == ':') {
        text->about = base_copy(value + id + 1 + strspn(value + id + 1, " "),
                                strlen(value + id + 1 + strspn(value + id + 1, " ")));
        free(value);
    } else {
        buffer_print(notes, "%s\n", value);
        free(value);
    }
}

/* The comment lines at the top; returns the text after them. */
static const char *header(form *text, int *line)
{
    buffer notes = {0};
    const char *at = text->text;
    *line = 1;
    while (strncmp(at, "//", 2) == 0) {
        size_t length = strcspn(at, "\n");
        size_t skip = 2 + strspn(at + 2, " ");
        if (skip > length)
            skip = length;
        size_t end = length;
        while (end > skip && (at[end - 1] == ' ' || at[end - 1] == '\r'))
            end--;
        header_line(text, at + skip, end - skip, *line == 1, &notes);
        at += length + (at[length] == '\n');
        (*line)++;
    }
    text->notes = notes.text ? notes.text : base_copy("", 0);
    return at;
}

static bool header_valid(const form *text)
{
    if (!text->about) {
        base_error("%s:1: expected \"// %s: what it is\"", text->path, text->id);
        return false;
    }
    if (text->helper)
        return true;
    if (!text->computes ||
        (strcmp(text->computes, "A_h") != 0 && strcmp(text->computes, "L") != 0)) {
        base_error("%s:1: expected a line \"// computes: A_h\" or \"// computes: L\"", text->path);
        return false;
    }
    return true;
}

static bool read_one(form *text, const char *folder, const char *name, bool helper)
{
    *text = (form){.path = base_join(folder, name), .helper = helper};
    text->id = base_copy(name, strlen(name) - strlen(".glsl"));
    text->text = base_read_file(text->path, NULL);
    if (!text->text)
        return false;
    int line;
    const char *function = header(text, &line);
    return header_valid(text) &&
           form_tokens(text->path, function, line, &text->tokens, &text->token_count) &&
           form_signature(text);
}

static bool read_folder(const char *folder, bool helper, form **texts, size_t *count)
{
    char **names;
    size_t name_count;
    *count = 0;
    if (!base_list(folder, ".glsl", &names, &name_count))
        return false;
    bool good = true;
    *texts = base_allocate((name_count + 1) * sizeof **texts);
    for (size_t i = 0; good && i < name_count; i++) {
        if (helper || is_formula(names[i]))
            good = read_one(&(*texts)[(*count)++], folder, names[i], helper);
    }
    base_list_free(names, name_count);
    return good;
}

/* Depth first through the calls; order receives the helpers, callees first. */
static bool visit(const form_list *list, size_t at, char *state, size_t *order, size_t *count)
{
    const form *text = &list->helpers[at];
    if (state[at] == 2)
        return true;
    if (state[at] == 1) {
        base_error("%s:1: expected no helper that calls itself, directly or through others",
                   text->path);
        return false;
    }
    state[at] = 1;
    size_t stand_in =
        text->c_double ? forms_helper(list, text->c_double, strlen(text->c_double)) : 0;
    for (size_t i = 0; i < list->helper_count; i++) {
        bool called = text->uses[i] || (text->c_double && i == stand_in);
        if (called && !visit(list, i, state, order, count))
            return false;
    }
    state[at] = 2;
    order[(*count)++] = at;
    return true;
}

/* Sorts the helpers, callees first, and renumbers what every text uses. */
static bool sort_helpers(form_list *list)
{
    size_t count = 0, total = list->helper_count;
    char *state = base_allocate(total + 1);
    size_t *order = base_allocate((total + 1) * sizeof *order);
    memset(state, 0, total + 1);
    bool good = true;
    for (size_t i = 0; good && i < total; i++)
        good = visit(list, i, state, order, &count);
    if (good) {
        form *sorted = base_allocate((total + 1) * sizeof *sorted);
        for (size_t i = 0; i < total; i++)
            sorted[i] = list->helpers[order[i]];
        free(list->helpers);
        list->helpers = sorted;
        for (size_t t = 0; t < total + list->form_count; t++) {
            form *text = t < total ? &list->helpers[t] : &list->forms[t - total];
            bool *uses = base_allocate((total + 1) * sizeof *uses);
            for (size_t i = 0; i < total; i++)
                uses[i] = text->uses[order[i]];
            free(text->uses);
            text->uses = uses;
        }
    }
    free(order);
    free(state);
    return good;
}

bool forms_read(form_list *list, const char *folder)
{
    *list = (form_list){0};
    char *helpers = base_join(folder, "helpers");
    bool good = read_folder(folder, false, &list->forms, &list->form_count) &&
                read_folder(helpers, true, &list->helpers, &list->helper_count);
    free(helpers);
    for (size_t i = 0; good && i < list->helper_count; i++)
        good = form_check(&list->helpers[i], list);
    for (size_t i = 0; good && i < list->form_count; i++)
        good = form_check(&list->forms[i], list);
    return good && sort_helpers(list);
}

static void free_texts(form *texts, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        form *text = &texts[i];
        char *owned[] = {text->path,     text->id,     text->text,     text->about,
                         text->computes, text->source, text->c_double, text->notes};
        for (size_t j = 0; j < sizeof owned / sizeof owned[0]; j++)
            free(owned[j]);
        for (size_t j = 0; j < text->coefficient_count; j++)
            free(text->coefficients[j]);
        free(text->coefficients);
        free(text->tokens);
        free(text->uses);
    }
    free(texts);
}

void forms_free(form_list *list)
{
    free_texts(list->forms, list->form_count);
    free_texts(list->helpers, list->helper_count);
    *list = (form_list){0};
}

const form *forms_find(const form_list *list, const char *id)
{
    for (size_t i = 0; i < list->form_count; i++) {
        if (strcmp(list->forms[i].id, id) == 0)
            return &list->forms[i];
    }
    return NULL;
}

size_t forms_helper(const form_list *list, const char *name, size_t length)
{
    size_t i = 0;
    while (i < list->helper_count && (strlen(list->helpers[i].id) != length ||
                                      memcmp(list->helpers[i].id, name, length) != 0))
        i++;
    return i;
}

void forms_mark(const form_list *list, const form *text, bool *needed)
{
    for (size_t i = 0; i < list->helper_count; i++) {
        if (text->uses[i] && !needed[i]) {
            needed[i] = true;
            forms_mark(list, &list->helpers[i], needed);
        }
    }
}
