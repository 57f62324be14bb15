/* form.h: form and helper texts (shaders/forms), read and checked.
 *
 * The texts are written in the subset that GLSL and C share: scalar functions of `real` and `bool`,
 * straight-line code, `?:`, every literal inside K(...). What passes the check here compiles
 * as C at any precision and as GLSL; a text that does not pass is answered by one line with file
 * and line. */
#ifndef TABLES_FORM_H
#define TABLES_FORM_H

#include <stdbool.h>
#include <stddef.h>

#include "base/buffer.h"

typedef enum token_kind { TOKEN_NAME, TOKEN_NUMBER, TOKEN_SIGN, TOKEN_BLANK, TOKEN_END } token_kind;

/* What a token stands for, found by the check; the writers go by it. */
typedef enum token_role {
    ROLE_PLAIN,       /* the same in both languages */
    ROLE_REAL,        /* the type real */
    ROLE_LITERAL,     /* the K of K(1.5) */
    ROLE_COEFFICIENT, /* index: which */
    ROLE_BUILTIN,     /* a GLSL built-in function */
    ROLE_HELPER,      /* a call of a helper, or a helper's own name */
    ROLE_PI,          /* sg_pi */
    ROLE_SELF         /* sg_form, where a form is defined */
} token_role;

typedef struct token {
    const char *start; /* points into form.text */
    size_t length;
    int line;
    token_kind kind;
    token_role role;
    size_t index;
} token;

typedef struct form {
    char *path; /* as shown in diagnostics */
    char *id;   /* the file's name: meder_logistic, sg_erf */
    char *text;
    bool helper;
    char *about;    /* what follows "ID: " in the first line */
    char *notes;    /* further comment lines, each ended by a newline; may be "" */
    char *computes; /* forms: A_h or L */
    char *source;   /* may be NULL */
    char *c_double; /* helpers: what stands in for it in the double unit, a function of the C
                       library or another helper; or NULL */
    char **coefficients;
    size_t coefficient_count;
    token *tokens; /* of the function, blanks and comments included; ends with TOKEN_END */
    size_t token_count;
    size_t parameter_count;
    bool *uses; /* forms_list.helpers that this text calls */
    bool uses_pi;
} form;

typedef struct form_list {
    form *forms; /* sorted by id */
    size_t form_count;
    form *helpers; /* sorted so that each stands after those that it calls */
    size_t helper_count;
} form_list;

/* Reads FOLDER/NAME.glsl and FOLDER/helpers/NAME.glsl; lobe.glsl and table.glsl, which are plain
 * GLSL, are left out. False after one line. */
bool forms_read(form_list *list, const char *folder);
void forms_free(form_list *list);
const form *forms_find(const form_list *list, const char *id);
/* Index of a helper, or helper_count. */
size_t forms_helper(const form_list *list, const char *name, size_t length);

/* Marks the helpers that `text` needs, with all that they need. */
void forms_mark(const form_list *list, const form *text, bool *needed);

/* Cuts text into tokens, blanks and comments included, numbered from first_line. False after one
 * line. */
bool form_tokens(const char *path, const char *text, int first_line, token **tokens, size_t *count);
bool token_is(const token *token, const char *text);

/* Checks the function in one text, fills roles, uses and uses_pi. form_signature fills
 * parameter_count, which the check of other texts needs. */
bool form_signature(form *text);
bool form_check(form *text, const form_list *list);

#endif
