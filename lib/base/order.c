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

static void swap(double *a, double *b)
{
    double kept = *a;
    *a = *b;
    *b = kept;
}

static double middle_of(double a, double b, double c)
{
    double low = a < b ? a : b, high = a < b ? b : a;
    return c < low ? low : c > high ? high : c;
}

double base_select(double *values, size_t count, size_t rank)
{
    size_t first = 0, last = count; /* the rank lies between */
    while (last - first > 1) {
        double pivot =
            middle_of(values[first], values[first + (last - first) / 2], values[last - 1]);
        size_t less = first, greater = last;
        for (size_t i = first; i < greater;) {
            if (values[i] < pivot)
                swap(&values[i++], &values[less++]);
            else if (values[i] > pivot)
                swap(&values[i], &values[--greater]);
            else
                i++;
        }
        if (rank < less)
            last = less;
        else if (rank >= greater)
            first = greater;
        else
            break;
    }
    return values[rank];
}

double base_median(double *values, size_t count)
{
    base_sort(values, count);
    return 0.5 * (values[(count - 1) / 2] + values[count / 2]);
}
