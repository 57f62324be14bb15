/* recipe.h: what to fit, read from fit/recipes/ID.json and checked before anything is run.
 *
 * Keys of a recipe (all others are refused):
 *
 * id, title    id is the file's name without .json
 * kind         "form": coefficients of a form, against the integral itself
 *              "curve": a steepness curve, against the best steepness of each sharpness
 *              "root": Tokuyoshi's error bound, where its derivative vanishes
 * form, curve  which one (shaders/forms, fit/curve.c)
 * quantity     of a form: "L" or "A_h" is what residuals are of
 * domain       {"lambda": [from, to], "beta": [from, to] in degrees}
 * grid         {"lambda": {"spacing": "log", "sqrt", "linear" or "shifted_log", "count": n},
 *               "angle": {"spacing": "beta", "cos_theta" or "terminator", "count": n}}.
 *               "shifted_log" is even in log(lambda + 2): few where nothing depends on lambda yet.
 *               "terminator", of a form and all angles: where L bends, |cos_theta| up to
 *               5.5/sqrt(lambda) or 1, denser towards 0 and that end, and the poles
 * weights      "uniform", or {"lambda": p, "value": q}: residuals times lambda^p value^q; or
 *              {"absolute": a, "relative": r, "down_to": v}, of a form: residuals over what is
 *              allowed there, a or r times the value, whichever is less; below v not at all
 * objective    "least_squares", "minimax" or "root"
 * start        coefficients that are fitted, and where from
 * fixed        coefficients that are held
 * bounds       {coefficient: [low, high]}
 * later        [coefficient], of a form: held at their start in a first least-squares fit, from
 *              which the fit of all then begins; for forms that extend a smaller one
 * seed, iterations   of the solvers
 * tolerance    {"solver": relative step at which one may stop,
 *               "agreement": largest relative difference between the two solvers,
 *               "repeat": the same between two machines}
 * epsilon      of a root: the machine epsilon in the bound
 * published    {"method": ID, "bars": {coefficient: largest relative difference},
 *               "beside": {coefficient: {"value": number, "where": text}}}: another print of
 *              a constant, shown beside the one in the method's file
 * tried        [{"what": text, and any of domain, grid, weights, objective, quantity, start,
 *               fixed}]: other ways to the same constants, shown beside the result
 * writes       {"id": ID, "title": text, "year": number}: a new constants file; "variant" of it may
 *              be given, "refit" (default) or "tier"
 * bars         {"rmse", "max_abs", "rmse_f32", "max_abs_f32"}: largest errors of L that are
 *              accepted, by the score
 * note         text, kept with the result
 */
#ifndef FIT_RECIPE_H
#define FIT_RECIPE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/json.h"
#include "fit/curve.h"
#include "fit/problem.h"
#include "sg.h"

typedef enum recipe_kind { RECIPE_FORM, RECIPE_CURVE, RECIPE_ROOT } recipe_kind;
typedef enum recipe_objective {
    RECIPE_LEAST_SQUARES,
    RECIPE_MINIMAX,
    RECIPE_SOLVE
} recipe_objective;
typedef enum recipe_spacing {
    SPACING_LOG,
    SPACING_SQRT,
    SPACING_LINEAR,
    SPACING_SHIFTED,
    SPACING_BETA,
    SPACING_COS,
    SPACING_TERMINATOR
} recipe_spacing;

typedef struct recipe_axis {
    double from, to; /* lambda, or beta in degrees */
    size_t count;
    recipe_spacing spacing;
} recipe_axis;

/* A coefficient of the form or curve, in its order. */
typedef struct recipe_coefficient {
    const char *name;
    bool free;
    double value; /* start or fixed */
    bool later;   /* held in a first fit of the others */
    double lower, upper;
    double bar;        /* of the published constant; NAN where none is given */
    double beside;     /* another print of it; NAN where there is none */
    const char *where; /* and where that stands */
} recipe_coefficient;

/* One way to fit; the recipe's own, or one that was tried as well. */
typedef struct recipe_way {
    const char *what; /* NULL for the recipe's own */
    sg_quantity quantity;
    recipe_axis lambda, angle;
    double weight_lambda, weight_value; /* powers */
    double absolute, relative, down_to; /* the other kind; absolute is 0 without it */
    recipe_objective objective;
    size_t coefficient_count;
    recipe_coefficient coefficients[FIT_MOST_PARAMETERS];
} recipe_way;

typedef struct recipe {
    char *path;
    cJSON *json; /* owns every text below */
    const char *id, *title, *note;
    recipe_kind kind;
    const sg_form *form;
    const fit_curve *curve;
    double epsilon;
    uint64_t seed;
    int iterations;
    double solver_tolerance, agreement, repeat;
    recipe_way way;
    recipe_way *tried;
    size_t tried_count;
    const char *published; /* method, or NULL */
    const char *writes, *writes_title, *writes_variant;
    int writes_year;
    double bar_rmse, bar_max, bar_rmse_f32, bar_max_f32; /* infinite where none is given */
} recipe;

/* Reads and checks; false after one line that names the file, the key and what was expected. */
bool recipe_read(recipe *r, const char *path);
void recipe_free(recipe *r);

/* Names for output: "log", "least_squares" ... */
const char *recipe_spacing_name(recipe_spacing spacing);
const char *recipe_objective_name(recipe_objective objective);

/* True if value is an object with no other keys than these; else one line that names the recipe's
 * file and the key that value stands at. */
bool recipe_object(const recipe *r, const char *key, const cJSON *value, const char *const *names);

/* recipe_way.c: reads what a way may say, over what is in it already. is_whole: every part must
 * be there. */
bool recipe_read_way(recipe *r, const cJSON *object, recipe_way *way, bool is_whole);

/* recipe_coefficients.c: the names of the form's or curve's coefficients, nothing known of them;
 * and what object says of them, over what is in the way already. */
void recipe_name_coefficients(const recipe *r, recipe_way *way);
bool recipe_read_coefficients(const recipe *r, const cJSON *object, recipe_way *way);

#endif
