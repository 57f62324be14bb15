/* parse.h: what the check of statements and the check of expressions share. Private. */
#ifndef TABLES_PARSE_H
#define TABLES_PARSE_H

#include "form.h"

typedef enum type { TYPE_ERROR, TYPE_REAL, TYPE_BOOL } type;

typedef struct variable {
    const token *name;
    type type;
    bool constant;
} variable;

enum { VARIABLES_MAX = 128, DEPTH_MAX = 200 };

typedef struct parser {
    form *text;
    const form_list *list;
    token *at;
    int depth;
    variable variables[VARIABLES_MAX];
    size_t variable_count;
} parser;

/* To the next token that is no blank. */
void parse_skip(parser *p); /* the present one included */
void parse_next(parser *p);

/* One line: what was expected at that token. Returns false. */
bool parse_refuse(const parser *p, const token *at, const char *expected);
bool parse_take(parser *p, const char *sign); /* that sign or a refusal */

const variable *parse_variable(const parser *p, const token *name);
bool parse_coefficient(const parser *p, const token *name, size_t *index);
bool parse_builtin(const token *name, size_t *parameters);

/* Checks an expression and leaves the parser behind it; TYPE_ERROR after a refusal. */
type parse_expression(parser *p);

#endif
