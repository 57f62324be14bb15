/* profile_savings.c: what a fit to a scene's lights saves against the tier that serves any scene.
 */
#include "profile_fit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/file.h"

static const struct {
    const char *file, *title;
} profiles[] = {
    {"broad.csv", "broad area light"}, {"sharp.csv", "many sharp lights"}, {"sky.csv", "the sky"}};
enum { PROFILES = sizeof profiles / sizeof *profiles };

typedef struct rows {
    profile_saving *list;
    size_t count;
} rows;

/* One row a tier: at that tier's own RMSE the cheapest tier, and the cheapest fit. */
static void compare(const choose_domain *domain, const profile_list *tiers,
                    const profile_list *ladder, const char *title, rows *to)
{
    for (size_t i = 0; i < tiers->count; i++) {
        double bar = tiers->list[i].rmse;
        const profile_candidate *general = profile_choose(tiers, false, (double)INFINITY, bar);
        const profile_candidate *fitted = profile_choose(ladder, false, (double)INFINITY, bar);
        if (general != &tiers->list[i] || !fitted)
            continue; /* another tier is both cheaper and better there */
        to->list = base_reallocate(to->list, (to->count + 1) * sizeof *to->list);
        to->list[to->count++] = (profile_saving){.profile = title,
                                                 .points = domain->count,
                                                 .lambda_min = domain->lambda_min,
                                                 .lambda_max = domain->lambda_max,
                                                 .bar = bar,
                                                 .general = *general,
                                                 .fitted = *fitted};
    }
}

static bool add_profile(profile_counter *counter, size_t index, rows *to)
{
    char *folder = base_join(base_source_root(), "tests/profiles");
    char *path = base_join(folder, profiles[index].file);
    choose_domain domain = {0};
    profile_list tiers = {0}, ladder = {0};
    double worst = 0.0;
    bool good = choose_profile(&domain, path) && profile_tiers(&domain, &tiers);
    for (size_t i = 0; good && i < tiers.count; i++)
        worst = fmax(worst, tiers.list[i].rmse);
    good = good && profile_count(counter, &tiers) &&
           profile_ladders(&domain, false, worst, &ladder) && profile_count(counter, &ladder);
    if (good)
        compare(&domain, &tiers, &ladder, profiles[index].title, to);
    free(tiers.list);
    free(ladder.list);
    choose_domain_free(&domain);
    free(path);
    free(folder);
    return good;
}

profile_saving *profile_savings(size_t *count, const char **unit)
{
    profile_counter counter;
    rows made = {0};
    bool good = profile_counter_open(&counter);
    *unit = profile_counter_name(&counter);
    for (size_t i = 0; good && i < PROFILES; i++)
        good = add_profile(&counter, i, &made);
    profile_counter_close(&counter);
    *count = good ? made.count : 0;
    if (!good) {
        free(made.list);
        made.list = NULL;
    }
    return made.list;
}
