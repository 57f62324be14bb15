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

/* The comment above a method in GLSL. */
void emit_method_comment(buffer *out, const method *method);

#endif
