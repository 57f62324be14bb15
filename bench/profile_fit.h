/* profile_fit.h: our forms fitted to the lights of one scene, with no more terms than it needs.
 * Private to bench; `sgfit fit --profile` reaches it through fit_profile of fit/fit.h.
 *
 * A candidate is the form of a tier with some coefficients exactly 0, which a compiler folds away,
 * and the others fitted to the profile. Those of one form make a ladder, found by greedy backward
 * elimination: each rung has one zero more than the rung before. */
#ifndef BENCH_PROFILE_FIT_H
#define BENCH_PROFILE_FIT_H

#include <stdbool.h>
#include <stddef.h>

#include "choose.h"
#include "cost.h"
#include "fit/fit.h"
#include "fit/problem.h"
#include "tables/emit.h"

typedef struct profile_candidate {
    const sg_method *tier; /* whose form and start; with its own coefficients where not fitted */
    bool fitted;
    double coefficients[FIT_MOST_PARAMETERS];
    bool dropped[FIT_MOST_PARAMETERS];
    double max_abs, rmse; /* of L in float on the profile */
    bool safe;            /* finite and in [0, 1] at any sharpness and angle, in float */
    double instructions;
} profile_candidate;

typedef struct profile_list {
    profile_candidate *list;
    size_t count;
} profile_list;

double profile_error(const profile_candidate *candidate, bool by_max);

/* ---- profile_search.c: the candidates ----------------------------------------------------------
 */

/* Float errors on the profile, and whether it is safe; of the coefficients as they are. */
void profile_measure(const choose_domain *domain, profile_candidate *candidate);

/* The ladder of every form that a tier has; a ladder ends where the error passes most. Rungs are
 * not counted yet. False after one line. */
bool profile_ladders(const choose_domain *domain, bool by_max, double most, profile_list *found);

/* profile_worth.c: for the parameter j of a problem at its start, worth[place[j]] is the growth of
 * the sum of squares, to second order, where it becomes 0 and the others follow: x^2 / (H^-1)_jj.
 * 0 where no sample feels it. False where there is no memory or no derivative. */
bool profile_worths(const fit_problem *problem, const size_t *place, double *worth);

/* The tiers themselves, measured on the profile and not counted yet. */
bool profile_tiers(const choose_domain *domain, profile_list *found);

/* ---- profile_cost.c: text and instructions -----------------------------------------------------
 */

typedef struct profile_counter {
    form_list forms;
    cost_counter *gpu; /* NULL: static counts */
} profile_counter;

/* False after one line. Where RADV is not there, counts are static ones. */
bool profile_counter_open(profile_counter *counter);
void profile_counter_close(profile_counter *counter);
const char *profile_counter_name(const profile_counter *counter); /* "navi21" or "static" */
bool profile_count(profile_counter *counter, profile_list *candidates);
/* The include with sg_L_profile and sg_A_h_profile, to a file. False after one line. */
bool profile_emit(const profile_counter *counter, const profile_candidate *candidate,
                  const choose_domain *domain, const char *path);

/* profile_static.c: operations of a form with these coefficients, after what zeros and ones fold
 * away: one each for additions, products (a product that only an addition uses is one with it),
 * minima and functions, two for a quotient; signs, magnitudes and clamping to [0, 1] are free.
 * False after one line, where the text is not of the kind that forms/ has. */
bool profile_static_count(const form *text, const double *coefficients, double *count);

/* ---- profile_fit.c: the choice -----------------------------------------------------------------
 */

/* The least error within budget, or with most (not NaN) the fewest instructions under it; safe ones
 * only, of equal ones the better. NULL where there is none. */
const profile_candidate *profile_choose(const profile_list *candidates, bool by_max, double budget,
                                        double most);
/* fit_profile of fit/fit.h. */
int profile_fit(const fit_profile_request *request);

/* profile_write.c: the choice as a constants file. False after one line. */
bool profile_write(const fit_profile_request *request, const choose_domain *domain,
                   const profile_counter *counter, const profile_candidate *chosen,
                   const profile_candidate *general);

/* profile_savings.c: one comparison at equal error. */
typedef struct profile_saving {
    const char *profile; /* "broad area light" */
    size_t points;
    double lambda_min, lambda_max, bar; /* RMSE that both stay under: the general tier's own */
    profile_candidate general, fitted;
} profile_saving;

/* Three profiles against each tier. free() them; NULL after one line. */
profile_saving *profile_savings(size_t *count, const char **unit);

#endif
