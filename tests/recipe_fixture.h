/* recipe_fixture.h: a small recipe, changed in one place, and what `sgfit fit` does with it. */
#ifndef TESTS_RECIPE_FIXTURE_H
#define TESTS_RECIPE_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "capture.h"
#include "program.h"
#include "workspace.h"

#include "base/json.h"

/* A recipe that takes milliseconds; @ stands where a test changes it. */
static const char *const parts[][2] = {
    {"id", "\"small\""},
    {"title", "\"a small fit\""},
    {"kind", "\"form\""},
    {"form", "\"logistic_limits\""},
    {"quantity", "\"L\""},
    {"domain", "{\"lambda\": [0.01, 1000], \"beta\": [0, 180]}"},
    {"grid",
     "{\"lambda\": {\"spacing\": \"log\", \"count\": 20}, \"angle\": {\"spacing\": \"beta\", "
     "\"count\": 21}}"},
    {"weights", "\"uniform\""},
    {"objective", "\"least_squares\""},
    {"start", "{\"u_1\": 0.2, \"u_infinity\": 1.5}"},
    {"fixed", "{\"t_infinity\": 2.1583, \"p_1\": 13.7, \"q_1\": 11.5, "
              "\"q_2\": -27.5, \"q_3\": 470}"},
    {"seed", "1"},
    {"iterations", "200"},
    {"tolerance", "{\"solver\": 1e-10, \"agreement\": 1e-6, \"repeat\": 1e-6}"},
    {"writes", "{\"id\": \"small_refit\", \"title\": \"small\", \"year\": 2026}"},
    {"bars", "{\"max_abs\": 1e-2}"},
};
enum { PARTS = sizeof parts / sizeof *parts };

/* The recipe with one key's value replaced (NULL: left out), and more text before the end. */
static inline void write_recipe(workspace *at, const char *key, const char *value, const char *more)
{
    char text[4096] = "{\n";
    for (size_t i = 0; i < PARTS; i++) {
        const char *is = key && strcmp(parts[i][0], key) == 0 ? value : parts[i][1];
        if (is)
            snprintf(text + strlen(text), sizeof text - strlen(text), "%s\"%s\": %s",
                     strlen(text) > 2 ? ",\n" : "", parts[i][0], is);
    }
    snprintf(text + strlen(text), sizeof text - strlen(text), "%s\n}\n", more ? more : "");
    workspace_write(at, "small.json", text);
}

static inline run run_recipe(workspace *at)
{
    char recipe[1100], out[1100];
    snprintf(recipe, sizeof recipe, "%s/small.json", at->folder);
    snprintf(out, sizeof out, "%s/out", at->folder);
    return RUN(NULL, "fit", "--out", out, recipe);
}

static inline char *written(workspace *at, const char *id)
{
    char name[128];
    snprintf(name, sizeof name, "out/%s.json", id);
    return workspace_read_path(workspace_path(at, name), NULL);
}

#endif
