/* fit_table.h: scoring recipes' results, holding them to their bars, and the table of `sgfit fit`.
 */
#ifndef FIT_FIT_TABLE_H
#define FIT_FIT_TABLE_H

#include "fit/constants_file.h"

/* Scores the form with what was found (published coefficients for those that the recipe does not
 * fit) and fails the result where it is beyond a bar of its recipe. */
void fit_score_recipe(const constants_set *set, const recipe *r, recipe_result *result);

/* CSV to standard output: recipe,constant,published,ours,difference,relative,bar,how */
void fit_print_table(const constants_set *set, const recipe *recipes, const recipe_result *results,
                     size_t count);

/* What the constants files hold of an earlier run of the recipe; false where nothing. */
bool fit_committed(const constants_set *set, const recipe *r, const char *coefficient,
                   double *value);

#endif
