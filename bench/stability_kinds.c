/* stability_kinds.c: what counts as a failure, and the values that it is judged by. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "stability_private.h"

typedef enum judgement {
    ERROR,    /* farther than the threshold from the truth */
    ROUNDING, /* ... from the twin */
    FLUSHED,  /* ... from the value without flushing */
    NEGATIVE,
    ABOVE_ONE,
    INFINITE,
    NOT_A_NUMBER
} judgement;

static const struct kind {
    const char *name;
    judgement judgement;
    double threshold;
    bool of_A_h;
    bool not_in_half;
} kinds[STABILITY_KINDS] = {{"error_1e-4", ERROR, 1e-4, false, false},
                            {"error_1e-3", ERROR, 1e-3, false, false},
                            {"error_1e-2", ERROR, 1e-2, false, false},
                            {"rounding_1e-6", ROUNDING, 1e-6, false, true},
                            {"rounding_1e-3", ROUNDING, 1e-3, false, false},
                            {"rounding_1e-2", ROUNDING, 1e-2, false, false},
                            {"negative", NEGATIVE, 0, false, false},
                            {"above_one", ABOVE_ONE, 0, false, false},
                            {"infinite", INFINITE, 0, false, false},
                            {"nan", NOT_A_NUMBER, 0, false, false},
                            {"A_h_negative", NEGATIVE, 0, true, false},
                            {"A_h_infinite", INFINITE, 0, true, false},
                            {"A_h_nan", NOT_A_NUMBER, 0, true, false},
                            {"flushed", FLUSHED, 1e-6, false, false}};

const char *stability_kind_name(int kind)
{
    return kinds[kind].name;
}

/* Where both are numbers; a failure to be one has kinds of its own. */
static double distance(const double *from, size_t i, double value, double threshold, double *worst)
{
    if (!from || !isfinite(value) || !isfinite(from[i]))
        return 0;
    *worst = fabs(value - from[i]);
    return *worst > threshold ? *worst : 0;
}

double stability_severity(int kind, const stability_subject *subject,
                          const stability_values *values, size_t i, double *worst)
{
    const struct kind *k = &kinds[kind];
    if ((k->of_A_h && !values->A_h) || (k->not_in_half && subject->precision == STABILITY_F16))
        return 0;
    double value = k->of_A_h ? values->A_h[i] : values->value[i];
    *worst = value;
    switch (k->judgement) {
    case ERROR:
        return distance(values->truth, i, value, k->threshold, worst);
    case ROUNDING:
        return distance(values->twin, i, value, k->threshold, worst);
    case FLUSHED:
        if (values->flushed && isfinite(value) != isfinite(values->flushed[i])) {
            *worst = values->flushed[i];
            return (double)INFINITY;
        }
        return distance(values->flushed, i, value, k->threshold, worst);
    case NEGATIVE:
        return value < 0 && isfinite(value) ? -value : 0;
    case ABOVE_ONE:
        return value > 1 && isfinite(value) && !subject->any_size ? value : 0;
    case INFINITE:
        return isinf(value) ? 1 : 0;
    default:
        return isnan(value) ? 1 : 0;
    }
}

static bool fill(stability_function function, const stability_subject *subject, size_t n,
                 const double *lambda, const double *cos_theta, double **out)
{
    *out = function ? stability_allocate(n * sizeof **out) : NULL;
    return !function || function(subject, n, lambda, cos_theta, *out);
}

bool stability_evaluate(const stability_subject *subject, size_t n, const double *lambda,
                        const double *cos_theta, const double *known_truth,
                        stability_values *values)
{
    *values = (stability_values){0};
    values->truth = stability_allocate(n * sizeof *values->truth);
    bool good = true;
    if (subject->truth)
        good = subject->truth(subject, n, lambda, cos_theta, values->truth);
    else if (known_truth)
        memcpy(values->truth, known_truth, n * sizeof *known_truth);
    else
        sg_L_cos_batch(n, lambda, cos_theta, values->truth);
    good = good && fill(subject->value, subject, n, lambda, cos_theta, &values->value) &&
           fill(subject->twin, subject, n, lambda, cos_theta, &values->twin) &&
           fill(subject->flushed, subject, n, lambda, cos_theta, &values->flushed) &&
           fill(subject->A_h, subject, n, lambda, cos_theta, &values->A_h);
    if (!good)
        stability_values_free(values);
    return good;
}

void stability_values_free(stability_values *values)
{
    free(values->value);
    free(values->truth);
    free(values->twin);
    free(values->flushed);
    free(values->A_h);
    *values = (stability_values){0};
}
