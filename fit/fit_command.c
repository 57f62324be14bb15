/* fit_command.c: `sgfit fit`. */
#include "fit/fit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/file.h"
#include "base/options.h"
#include "base/progress.h"
#include "base/text.h"
#include "fit/constants_file.h"
#include "fit/fit_table.h"

typedef struct fit_run {
    size_t count;
    recipe *recipes;
    recipe_result *results;
    constants_set constants;
    base_progress *progress;
} fit_run;

/* ---- Reading ------------------------------------------------------------------------------- */

/* A name of fit/recipes, or a file. */
static char *recipe_path(const char *name)
{
    char file[256];
    size_t length = strlen(name);
    if (strchr(name, '/') || (length > 5 && strcmp(name + length - 5, ".json") == 0))
        return strdup(name);
    snprintf(file, sizeof file, "fit/recipes/%.200s.json", name);
    return base_join(base_source_root(), file);
}

static bool add_recipe(fit_run *run, char *path)
{
    if (path && access(path, F_OK) != 0) {
        base_error("fit: no recipe %.200s (sgfit fit --list lists those of fit/recipes)", path);
        free(path);
        return false;
    }
    bool good = path && recipe_read(&run->recipes[run->count], path);
    if (good)
        run->count++;
    free(path);
    return good;
}

static bool add_all(fit_run *run)
{
    char *folder = base_join(base_source_root(), "fit/recipes"), **names;
    size_t count;
    bool good = folder && base_list(folder, ".json", &names, &count);
    if (good) {
        run->recipes = calloc(count + 1, sizeof *run->recipes);
        good = run->recipes != NULL;
        for (size_t i = 0; good && i < count; i++)
            good = add_recipe(run, base_join(folder, names[i]));
        base_list_free(names, count);
    }
    free(folder);
    return good;
}

static bool read_recipes(fit_run *run, int count, char **names)
{
    if (count == 0)
        return add_all(run);
    run->recipes = calloc((size_t)count + 1, sizeof *run->recipes);
    bool good = run->recipes != NULL;
    for (int i = 0; good && i < count; i++)
        good = add_recipe(run, recipe_path(names[i]));
    return good;
}

/* What recipes say of published methods must be there to be compared with. */
static bool check_published(const fit_run *run)
{
    for (size_t i = 0; i < run->count; i++) {
        const recipe *r = &run->recipes[i];
        double value;
        if (r->published && !constants_set_find(&run->constants, r->published)) {
            base_error("%s: key \"published.method\": expected a method of tables/constants, found "
                       "\"%.60s\"",
                       r->path, r->published);
            return false;
        }
        for (size_t k = 0; k < r->way.coefficient_count; k++) {
            const recipe_coefficient *c = &r->way.coefficients[k];
            if (!isnan(c->bar) &&
                !constants_published(&run->constants, r->published, c->name, &value)) {
                base_error("%s: key \"published.bars.%s\": expected a coefficient of %s", r->path,
                           c->name, r->published);
                return false;
            }
        }
    }
    return true;
}

/* ---- Running ------------------------------------------------------------------------------- */

static void run_one(void *context, size_t index)
{
    fit_run *run = context;
    recipe_run(&run->recipes[index], &run->results[index]);
    base_progress_step(run->progress, run->recipes[index].id);
}

static void run_all(fit_run *run)
{
    run->progress = base_progress_begin("fitting", run->count);
    base_parallel(run->count, run_one, run);
    base_progress_end(run->progress);
    run->progress = base_progress_begin("scoring", run->count);
    for (size_t i = 0; i < run->count; i++) {
        fit_score_recipe(&run->constants, &run->recipes[i], &run->results[i]);
        base_progress_step(run->progress, run->recipes[i].id);
    }
    base_progress_end(run->progress);
}

static bool report_failures(const fit_run *run)
{
    bool failed = false;
    for (size_t i = 0; i < run->count; i++) {
        if (run->results[i].failed)
            base_error("fit: %s", run->results[i].why);
        failed = failed || run->results[i].failed;
    }
    return failed;
}

/* The constants of the tree against those just fitted, to the tolerance that each recipe states. */
static bool check_repeat(const fit_run *run)
{
    bool good = true;
    for (size_t i = 0; i < run->count; i++) {
        const recipe *r = &run->recipes[i];
        for (size_t k = 0; k < r->way.coefficient_count; k++) {
            double before, now = run->results[i].own.coefficients[k];
            if (!r->way.coefficients[k].free ||
                !fit_committed(&run->constants, r, r->way.coefficients[k].name, &before))
                continue;
            double difference = fit_disagreement(1, &before, &now);
            if (difference <= r->repeat)
                continue;
            base_error("fit: %s: %s differs from tables/constants by %.2g, expected at most %.2g",
                       r->id, r->way.coefficients[k].name, difference, r->repeat);
            good = false;
        }
    }
    return good;
}

static bool write_all(fit_run *run, const char *folder)
{
    for (size_t i = 0; i < run->count; i++)
        if (!constants_record(&run->constants, &run->recipes[i], &run->results[i]))
            return false;
    base_progress *progress = base_progress_begin("measuring", run->constants.count);
    bool good = constants_measure(&run->constants, progress);
    base_progress_end(progress);
    return good && base_make_directory(folder) && constants_set_write(&run->constants, folder);
}

static void list_recipes(const fit_run *run)
{
    puts("recipe,objective,published,writes,title");
    for (size_t i = 0; i < run->count; i++) {
        const recipe *r = &run->recipes[i];
        printf("%s,%s,%s,%s,\"%s\"\n", r->id, recipe_objective_name(r->way.objective),
               r->published ? r->published : "", r->writes ? r->writes : "", r->title);
    }
}

static int work(fit_run *run, const char *out, bool only_check)
{
    run->results = calloc(run->count + 1, sizeof *run->results);
    if (!run->results)
        return BASE_FAILED;
    run_all(run);
    fit_print_table(&run->constants, run->recipes, run->results, run->count);
    if (report_failures(run))
        return BASE_FAILED;
    if (only_check)
        return check_repeat(run) ? BASE_DONE : BASE_FAILED;
    return write_all(run, out) ? BASE_DONE : BASE_FAILED;
}

/* `sgfit fit RECIPE ...` */
static int fit_recipes(int count, char **names, const char *out, bool list, bool check)
{
    fit_run run = {0};
    char *folder = out ? strdup(out) : base_join(base_source_root(), "tables/constants");
    int status = BASE_USAGE;
    if (read_recipes(&run, count, names)) {
        if (list) {
            list_recipes(&run);
            status = BASE_DONE;
        } else if (!check && !base_can_fill(folder)) {
            status = BASE_FAILED; /* a write, not a wrong use */
        } else if (constants_set_read(&run.constants, folder) && check_published(&run)) {
            status = work(&run, folder, check);
        }
    }
    for (size_t i = 0; i < run.count; i++) {
        if (run.results)
            recipe_result_free(&run.results[i]);
        recipe_free(&run.recipes[i]);
    }
    free(run.recipes);
    free(run.results);
    constants_set_free(&run.constants);
    free(folder);
    return status;
}

int (*fit_profile)(const fit_profile_request *request);

/* `sgfit fit --profile FILE`: checks what was asked for. */
static int fit_to_profile(const fit_profile_request *request, bool recipes)
{
    if (recipes)
        base_error("fit: --profile goes without recipes, --list and --check");
    else if (request->budget_given && !(request->budget >= 1.0))
        base_error("fit: --budget: expected at least 1 instruction, found %g", request->budget);
    else if (request->max_error_given && !(request->max_error > 0.0))
        base_error("fit: --max-error: expected an error above 0, found %g", request->max_error);
    else if (!fit_profile)
        base_error("fit: --profile: this program was built without it");
    else
        return fit_profile(request);
    return BASE_USAGE;
}

int fit_command(int argc, char **argv)
{
    bool list = false, check = false, metric_given = false;
    const char *metric = "rmse";
    fit_profile_request profile = {0};
    const base_option options[] = {
        {"list", BASE_FLAG, &list, NULL, "lists the recipes and ends", NULL},
        {"out", BASE_STRING, &profile.out, "DIR",
         "writes the constants there (default: tables/constants of the source tree); "
         "with --profile a file, and nothing where it is not given",
         NULL},
        {"check", BASE_FLAG, &check, NULL,
         "writes nothing; fails where a constant of the tree is further from "
         "the new one than its recipe allows",
         NULL},
        {"profile", BASE_STRING, &profile.profile, "FILE",
         "instead of recipes: fits our forms, with no more terms than needed, to a CSV of "
         "lambda, cos_theta and weight, and prints what each candidate costs there",
         NULL},
        {"budget", BASE_F64, &profile.budget, "N",
         "with --profile: the least error within N GPU instructions", &profile.budget_given},
        {"max-error", BASE_F64, &profile.max_error, "E",
         "with --profile: the fewest instructions whose error stays under E (default, "
         "without --budget: the error of the cheapest tier on that profile)",
         &profile.max_error_given},
        {"metric", BASE_CHOICE, &metric, "max|rmse", "with --profile: which error (default: rmse)",
         &metric_given},
        {"emit", BASE_STRING, &profile.emit, "FILE",
         "with --profile: writes the shader include with sg_L_profile and sg_A_h_profile", NULL},
    };
    const base_usage usage = {
        "fit", "[options] [RECIPE ...]",
        "Runs recipes of fit/recipes (default: all; a name or a file), prints every constant "
        "beside "
        "the published one, and writes tables/constants. Nothing is written if one fails."};
    int positional = 0;
    int status = base_parse_options(argc, argv, &usage, options, sizeof options / sizeof *options,
                                    &positional);
    if (status >= 0)
        return status;
    profile.by_max = strcmp(metric, "max") == 0;
    if (profile.profile)
        return fit_to_profile(&profile, positional > 0 || list || check);
    if (profile.budget_given || profile.max_error_given || metric_given || profile.emit) {
        base_error("fit: --budget, --max-error, --metric and --emit go with --profile FILE");
        return BASE_USAGE;
    }
    return fit_recipes(positional, argv + 1, profile.out, list, check);
}
