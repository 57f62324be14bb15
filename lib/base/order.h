/* order.h: order statistics of doubles. */
#ifndef BASE_ORDER_H
#define BASE_ORDER_H

#include <stddef.h>

/* Sorts from the least to the greatest; no NaN among them. */
void base_sort(double *values, size_t count);

/* The value that would be at index rank (below count) after sorting; orders them only as far as
 * that needs: none before index rank is greater, none after it less. NaNs end up anywhere. */
double base_select(double *values, size_t count, size_t rank);

/* Sorts them; the mean of the two in the middle where count is even. count: at least 1. */
double base_median(double *values, size_t count);

#endif
