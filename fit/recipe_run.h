/* recipe_run.h: samples of a recipe, its solution by both solvers, and the score of the result. */
#ifndef FIT_RECIPE_RUN_H
#define FIT_RECIPE_RUN_H

#include "fit/recipe.h"
#include "fit/score.h"
#include "fit/solve.h"

/* What one way gave. */
typedef struct way_result {
    bool usable;
    double coefficients[FIT_MOST_PARAMETERS]; /* all of the way's, in its order, held ones too */
    size_t samples;
    double rms, largest; /* of the residuals (of the way's own quantity) */
    int solver_count;
    fit_result solvers[2]; /* the first one's result is the way's */
    double disagreement;   /* between the two, relative; 0 for one */
} way_result;

typedef struct recipe_result {
    way_result own;
    way_result *tried; /* recipe's tried_count */
    bool scored;
    score_result score_f64, score_f32;
    /* Where a constant has another print: the published method as it stands, and with that. */
    bool has_beside;
    score_result score_published, score_beside;
    bool failed;
    char why[256]; /* of a failure: one line */
} recipe_result;

/* Solves the recipe's own way and the tried ones; single-threaded. */
void recipe_run(const recipe *r, recipe_result *result);
void recipe_result_free(recipe_result *result);

/* Writes a failure's line once; later ones are dropped. */
void recipe_fail(recipe_result *result, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* recipe_samples.c: the problem of one way. False where memory is short. The context that its
 * model needs is kept in *context, which must live as long as the problem. */
typedef struct way_context {
    const recipe *recipe;
    const recipe_way *way;
    size_t free_index[FIT_MOST_PARAMETERS]; /* parameter j is coefficient free_index[j] */
} way_context;

bool recipe_samples(const recipe *r, const recipe_way *way, way_context *context,
                    fit_problem *problem);

/* The curve's first stage alone: the best steepness at every sharpness of the way's grid. All three
 * arrays hold way->lambda.count; u may be NULL. */
bool recipe_steepness(const recipe *r, const recipe_way *way, double *lambda, double *t, double *u);

/* Point index of an axis. */
double recipe_axis_at(const recipe_axis *axis, size_t index);

#endif
