#include "order.h"

#include <stdlib.h>

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void base_sort(double *values, size_t count)
{
    qsort(values, count, sizeof *values, ascending);
}

double base_median(double *values, size_t count)
{
    base_sort(values, count);
    return 0.5 * (values[(count - 1) / 2] + values[count / 2]);
}
