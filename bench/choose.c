/* choose.c: sgfit choose. */
#include "choose.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/json.h"
#include "base/options.h"
#include "base/text.h"
#include "tables/tables.h"

typedef struct candidate {
    const sg_method *method;
    double cost, error; /* by the metric asked for */
    choose_error errors;
} candidate;

/* Cheapest first; of equally cheap ones the better. */
static int by_cost(const void *a, const void *b)
{
    const candidate *x = a, *y = b;
    if (x->cost != y->cost)
        return x->cost < y->cost ? -1 : 1;
    if (x->error != y->error)
        return x->error < y->error ? -1 : 1;
    return strcmp(x->method->id, y->method->id);
}

/* Measures every method that is declared for the whole domain and has a cost. */
static bool measure_all(const choose_domain *domain, const double *costs, bool rmse,
                        candidate *list, size_t *count)
{
    *count = 0;
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *method = sg_method_at(i);
        if (isnan(costs[i]) || domain->lambda_min < method->lambda_min ||
            domain->lambda_max > method->lambda_max)
            continue;
        candidate *c = &list[(*count)++];
        *c = (candidate){.method = method, .cost = costs[i]};
        if (!choose_measure(domain, method, &c->errors))
            return false;
        c->error = rmse ? c->errors.rmse : c->errors.max_abs;
    }
    qsort(list, *count, sizeof *list, by_cost);
    return true;
}

typedef struct choice {
    const candidate *chosen, *cheaper, *better; /* any may be NULL */
} choice;

/* cheaper: the best of those that cost less (it misses); better: the cheapest of those whose error
 * is below the chosen one's. */
static choice choose(const candidate *list, size_t count, double most)
{
    choice c = {0};
    for (size_t i = 0; i < count && !c.chosen; i++)
        if (list[i].error <= most)
            c.chosen = &list[i];
    for (size_t i = 0; c.chosen && i < count; i++) {
        const candidate *other = &list[i];
        if (other->cost < c.chosen->cost && (!c.cheaper || other->error < c.cheaper->error))
            c.cheaper = other;
        if (!c.better && other->cost > c.chosen->cost && other->error < c.chosen->error)
            c.better = other;
    }
    return c;
}

static void print_row(const char *role, const candidate *c, choose_unit unit)
{
    char cost[BASE_NUMBER_SIZE], max_abs[BASE_NUMBER_SIZE], lambda[BASE_NUMBER_SIZE],
        cos_theta[BASE_NUMBER_SIZE], rmse[BASE_NUMBER_SIZE];
    if (c)
        printf("%s,%s,%s,%s,%s,%s,%s,%s\n", role, c->method->id, base_shortest_f64(c->cost, cost),
               choose_unit_name(unit), base_shortest_f64(c->errors.max_abs, max_abs),
               base_shortest_f32((float)c->errors.lambda, lambda),
               base_shortest_f32((float)c->errors.cos_theta, cos_theta),
               base_shortest_f64(c->errors.rmse, rmse));
}

static void add_role(cJSON *root, const char *role, const candidate *c, choose_unit unit)
{
    if (!c) {
        cJSON_AddNullToObject(root, role);
        return;
    }
    cJSON *object = cJSON_AddObjectToObject(root, role);
    cJSON_AddStringToObject(object, "method", c->method->id);
    base_json_add_f64(object, "cost", c->cost);
    cJSON_AddStringToObject(object, "unit", choose_unit_name(unit));
    base_json_add_f64(object, "max_abs", c->errors.max_abs);
    base_json_add_f64(object, "max_abs_lambda", c->errors.lambda);
    base_json_add_f64(object, "max_abs_cos_theta", c->errors.cos_theta);
    base_json_add_f64(object, "rmse", c->errors.rmse);
}

static void print_choice(const choice *c, choose_unit unit, bool json)
{
    if (!json) {
        puts("role,method,cost,unit,max_abs,max_abs_lambda,max_abs_cos_theta,rmse");
        print_row("chosen", c->chosen, unit);
        print_row("next_cheaper", c->cheaper, unit);
        print_row("next_better", c->better, unit);
        return;
    }
    cJSON *root = cJSON_CreateObject();
    add_role(root, "chosen", c->chosen, unit);
    add_role(root, "next_cheaper", c->cheaper, unit);
    add_role(root, "next_better", c->better, unit);
    char *text = base_json_print(root);
    fputs(text, stdout);
    free(text);
    cJSON_Delete(root);
}

/* Writes the include with the chosen method alone, by the command that does it. */
static int emit(const char *path, const char *id)
{
    char *arguments[] = {"emit", "--out", (char *)path, "--method", (char *)id, NULL};
    for (const base_command *command = tables_commands; command->name; command++)
        if (strcmp(command->name, "emit") == 0)
            return command->run(5, arguments);
    return BASE_FAILED;
}

typedef struct request {
    double most;
    bool most_given, lambda_given, json;
    const char *metric, *lambda, *profile, *cost, *rate, *emit, *device;
} request;

static bool unit_of(const request *r, choose_unit *unit)
{
    bool gpu = strcmp(r->cost, "gpu") == 0, split = strcmp(r->rate, "split") == 0;
    if (split && !gpu) {
        base_error(
            "choose: --rate split goes with --cost gpu: only instructions are counted apart");
        return false;
    }
    *unit = split                         ? CHOOSE_GPU_PIXEL
            : gpu                         ? CHOOSE_GPU
            : strcmp(r->cost, "cpu") == 0 ? CHOOSE_CPU
                                          : CHOOSE_DEVICE;
    return true;
}

/* The domain and unit asked for; BASE_DONE or the exit status after one line. */
static int prepare(const request *r, choose_unit *unit, choose_domain *domain)
{
    double low = 1e-3, high = 1e4;
    if (!r->most_given || !(r->most > 0.0)) {
        base_error("choose: expected --max-error E with E above 0");
        return BASE_USAGE;
    }
    if (r->profile && r->lambda_given) {
        base_error("choose: expected --lambda or --profile, found both");
        return BASE_USAGE;
    }
    if (!unit_of(r, unit) || (r->lambda_given && !choose_parse_range(r->lambda, &low, &high)))
        return BASE_USAGE;
    bool good = r->profile ? choose_profile(domain, r->profile) : choose_range(domain, low, high);
    return good ? BASE_DONE : BASE_USAGE;
}

static int run(const request *r)
{
    choose_unit unit = CHOOSE_GPU;
    choose_domain domain = {0};
    int status = prepare(r, &unit, &domain);
    if (status != BASE_DONE)
        return status;
    double *costs = malloc(sizeof *costs * sg_method_count());
    candidate *list = malloc(sizeof *list * sg_method_count());
    if (!costs || !list)
        abort();
    size_t count = 0;
    bool rmse = strcmp(r->metric, "rmse") == 0;
    status = BASE_FAILED;
    bool writable = !r->emit || base_can_write(r->emit);
    if (writable && choose_costs(unit, r->device, costs) &&
        measure_all(&domain, costs, rmse, list, &count)) {
        choice found = choose(list, count, r->most);
        if (!count)
            base_error("choose: no method has a cost in %s here", choose_unit_name(unit));
        else if (!found.chosen)
            base_error("choose: no method stays under %g on this domain", r->most);
        else
            status = r->emit ? emit(r->emit, found.chosen->method->id) : BASE_DONE;
        if (found.chosen && status == BASE_DONE) {
            print_choice(&found, unit, r->json);
            status = base_finish_stdout() ? BASE_DONE : BASE_FAILED;
        }
    }
    free(costs);
    free(list);
    choose_domain_free(&domain);
    return status;
}

int choose_command(int argc, char **argv)
{
    request r = {.metric = "max", .cost = "gpu", .rate = "pixel", .device = "llvmpipe"};
    const base_usage usage = {
        "choose", "--max-error E [options]",
        "Names the cheapest method whose error of L, in float and measured on the domain given, "
        "stays under E; and beside it the best of the cheaper ones, which misses, and the next "
        "better one with its cost."};
    const base_option options[] = {
        {"max-error", BASE_F64, &r.most, "E", "largest error of L that is good enough",
         &r.most_given},
        {"metric", BASE_CHOICE, &r.metric, "max|rmse", "which error (default: max)", NULL},
        {"lambda", BASE_STRING, &r.lambda, "MIN:MAX", "sharpnesses (default: 1e-3:1e4)",
         &r.lambda_given},
        {"profile", BASE_STRING, &r.profile, "FILE",
         "instead: CSV with columns lambda, cos_theta and weight, as a scene produces it", NULL},
        {"cost", BASE_CHOICE, &r.cost, "gpu|cpu|device",
         "instructions of navi21, nanoseconds of the batch call, or time on the Vulkan device "
         "(default: gpu)",
         NULL},
        {"rate", BASE_CHOICE, &r.rate, "pixel|split",
         "split: only what is left where lambda is prepared once a light (default: pixel)", NULL},
        {"device", BASE_STRING, &r.device, "NAME", "part of the Vulkan device's name", NULL},
        {"emit", BASE_STRING, &r.emit, "FILE", "write the shader include with just that", NULL},
        {"json", BASE_FLAG, &r.json, NULL, "JSON instead of CSV", NULL}};
    int status =
        base_parse_options(argc, argv, &usage, options, sizeof options / sizeof *options, NULL);
    return status >= 0 ? status : run(&r);
}
