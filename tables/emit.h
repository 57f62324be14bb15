/* emit.h: the writers of generated text. Private to tables. Each is a pure function of its
 * arguments and gives the same bytes on every machine. */
#ifndef TABLES_EMIT_H
#define TABLES_EMIT_H

#include "constants.h"

/* tables/out/forms.inc, methods.inc, registry.inc: see lib/sg/methods.h. */
void emit_forms_inc(buffer *out, const form_list *forms);
void emit_methods_inc(buffer *out, const method_list *methods);
void emit_registry_inc(buffer *out, const form_list *forms, const method_list *methods);

/* shaders/sg.glsl; only: that method and what it needs, or NULL for all. `lobe` is the text of
 * shaders/forms/lobe.glsl, bound to method `irradiance`. False after one line. */
bool emit_glsl(buffer *out, const form_list *forms, const method_list *methods, const method *only,
               const char *lobe_path, const char *lobe, const method *irradiance);

/* shaders/sg_table.glsl, from the text of shaders/forms/table.glsl. It has copies of its own of
 * the helpers that it needs, named sg_table_, and can be included with sg.glsl or without. */
bool emit_table_glsl(buffer *out, const form_list *forms, const char *path, const char *text);

/* One function of a form or helper as GLSL, named `name`; helpers in it are named prefix plus what
 * follows "sg_" in their own name. */
void glsl_function(buffer *out, const form *text, const char *name, const double *coefficients,
                   const char *prefix);

/* The comments in GLSL: above a helper, which is named as glsl_function says; above a method's
 * native function and above the other. */
void comment_helper(buffer *out, const form *helper, const char *prefix);
void comment_method(buffer *out, const method *method);
void comment_other(buffer *out, const method *method);

#endif
