/* choose_domain.c: the points that a choice is made on, and errors there. */
#include "choose.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/csv.h"
#include "base/text.h"
#include "score.h"

static bool allocate(choose_domain *domain, size_t count)
{
    *domain = (choose_domain){.count = count,
                              .lambda = malloc(count * sizeof(float)),
                              .cos_theta = malloc(count * sizeof(float)),
                              .truth = malloc(count * sizeof(double)),
                              .weight = malloc(count * sizeof(double)),
                              .lambda_min = (double)INFINITY};
    if (domain->lambda && domain->cos_theta && domain->truth && domain->weight)
        return true;
    choose_domain_free(domain);
    base_error("choose: no memory for %zu points", count);
    return false;
}

void choose_domain_free(choose_domain *domain)
{
    free(domain->lambda);
    free(domain->cos_theta);
    free(domain->truth);
    free(domain->weight);
    *domain = (choose_domain){0};
}

static void fill_truth(choose_domain *domain)
{
    for (size_t i = 0; i < domain->count; i++) {
        double lambda = (double)domain->lambda[i];
        domain->truth[i] = sg_L_cos(lambda, (double)domain->cos_theta[i]);
        domain->lambda_min = fmin(domain->lambda_min, lambda);
        domain->lambda_max = fmax(domain->lambda_max, lambda);
    }
}

bool choose_parse_range(const char *text, double *low, double *high)
{
    const char *colon = strchr(text, ':');
    if (colon && base_parse_f64(text, (size_t)(colon - text), low) &&
        base_parse_f64(colon + 1, strlen(colon + 1), high) && *low >= 0.0 && *low <= *high &&
        *high <= 1e30)
        return true;
    base_error("choose: --lambda: expected MIN:MAX with 0 <= MIN <= MAX <= 1e30, found %s", text);
    return false;
}

bool choose_range(choose_domain *domain, double low, double high)
{
    if (!allocate(domain, (size_t)SCORE_LAMBDAS * SCORE_ANGLES))
        return false;
    double from = low > 0.0 ? low : fmin(1e-3, high);
    for (size_t i = 0; i < SCORE_LAMBDAS; i++) {
        double share = (double)i / (SCORE_LAMBDAS - 1);
        double lambda = from > 0.0 ? from * pow(high / from, share) : 0.0;
        if (i == 0)
            lambda = low; /* 0 itself, where the range begins there */
        if (i == SCORE_LAMBDAS - 1)
            lambda = high;
        for (size_t j = 0; j < SCORE_ANGLES; j++) {
            size_t k = i * SCORE_ANGLES + j;
            domain->lambda[k] = (float)lambda;
            domain->cos_theta[k] = (float)cos(score_beta(j));
            domain->weight[k] = 1.0;
        }
    }
    fill_truth(domain);
    return true;
}

/* One row of a profile into place `at`; -1 after one line, 0 where its weight is 0. */
static int read_row(const base_csv *csv, const int columns[3], choose_domain *domain, size_t at)
{
    double lambda, cos_theta, weight;
    if (!base_csv_f64(csv, columns[0], &lambda) || !base_csv_f64(csv, columns[1], &cos_theta) ||
        !base_csv_f64(csv, columns[2], &weight))
        return -1;
    const char *wrong = lambda < 0.0 || lambda > 1e30 ? "column lambda: expected 0 to 1e30"
                        : fabs(cos_theta) > 1.000001  ? "column cos_theta: expected -1 to 1"
                        : weight < 0.0                ? "column weight: expected 0 or more"
                                                      : NULL;
    if (wrong) {
        base_error("%s, line %ld, %s", csv->name, csv->line, wrong);
        return -1;
    }
    domain->lambda[at] = (float)lambda;
    domain->cos_theta[at] = (float)fmin(fmax(cos_theta, -1.0), 1.0);
    domain->weight[at] = weight;
    return weight > 0.0;
}

static bool grow(choose_domain *domain, size_t capacity)
{
    float *lambda = realloc(domain->lambda, capacity * sizeof *lambda);
    domain->lambda = lambda ? lambda : domain->lambda;
    float *cos_theta = realloc(domain->cos_theta, capacity * sizeof *cos_theta);
    domain->cos_theta = cos_theta ? cos_theta : domain->cos_theta;
    double *truth = realloc(domain->truth, capacity * sizeof *truth);
    domain->truth = truth ? truth : domain->truth;
    double *weight = realloc(domain->weight, capacity * sizeof *weight);
    domain->weight = weight ? weight : domain->weight;
    if (lambda && cos_theta && truth && weight)
        return true;
    base_error("choose: no memory for %zu points", capacity);
    return false;
}

static bool read_rows(base_csv *csv, choose_domain *domain)
{
    static const char *const names[3] = {"lambda", "cos_theta", "weight"};
    int columns[3];
    for (int i = 0; i < 3; i++) {
        columns[i] = base_csv_column(csv, names[i]);
        if (columns[i] < 0) {
            base_error("%s, line 1: expected a column %s", csv->name, names[i]);
            return false;
        }
    }
    size_t capacity = domain->count;
    domain->count = 0;
    int row;
    while ((row = base_csv_next(csv)) > 0) {
        if (domain->count == capacity && !grow(domain, capacity *= 2))
            return false;
        int used = read_row(csv, columns, domain, domain->count);
        if (used < 0)
            return false;
        domain->count += (size_t)used;
    }
    if (row == 0 && domain->count == 0)
        base_error("%s: expected at least one row with a weight above 0", csv->name);
    return row == 0 && domain->count > 0;
}

bool choose_profile(choose_domain *domain, const char *path)
{
    FILE *stream = fopen(path, "r");
    if (!stream) {
        base_error("%s: %s", path, strerror(errno));
        return false;
    }
    base_csv csv;
    bool good = base_csv_open(&csv, stream, path);
    if (good) {
        good = allocate(domain, 4096) && read_rows(&csv, domain);
        base_csv_close(&csv);
        if (good)
            fill_truth(domain);
        else
            choose_domain_free(domain);
    }
    fclose(stream);
    return good;
}

bool choose_measure(const choose_domain *domain, const sg_method *method, choose_error *error)
{
    float *values = malloc(domain->count * sizeof *values);
    if (!values) {
        base_error("choose: no memory for %zu values", domain->count);
        return false;
    }
    method->L_batch_f32(domain->count, domain->lambda, domain->cos_theta, values);
    double squares = 0.0, weights = 0.0;
    *error = (choose_error){.max_abs = -1.0};
    for (size_t i = 0; i < domain->count; i++) {
        double miss =
            isfinite(values[i]) ? fabs((double)values[i] - domain->truth[i]) : (double)INFINITY;
        squares += domain->weight[i] * miss * miss;
        weights += domain->weight[i];
        if (miss > error->max_abs) {
            error->max_abs = miss;
            error->lambda = (double)domain->lambda[i];
            error->cos_theta = (double)domain->cos_theta[i];
        }
    }
    error->rmse = sqrt(squares / weights);
    free(values);
    return true;
}
