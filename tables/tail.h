/* tail.h: the look-up table of the back-facing tail of L.
 *
 * T(lambda, c) = L(lambda, -c), c = |cos_theta| in [0, 1]; L(lambda, z) = m max(z, 0) + T(lambda,
 * |z|) with m = coth lambda - 1/lambda, exactly. Texel (i, j) of the table holds T sqrt(lambda + 2)
 * at u = lambda/(lambda + 2) = i/(TAIL_SIZE - 1), v = c sqrt(lambda + 2)/TAIL_REACH = j/(TAIL_SIZE
 * - 1), not its exact value there but the one with which bilinear interpolation has the smallest
 * largest error in L. Texture coordinates are ((TAIL_SIZE - 1) u + 1/2)/TAIL_SIZE, alike for v:
 * the outermost texel centres lie on the edges of the domain. */
#ifndef TABLES_TAIL_H
#define TABLES_TAIL_H

#include <stddef.h>

enum { TAIL_SIZE = 32 };
#define TAIL_REACH 4.5 /* in units of 1/sqrt(lambda + 2); T is below 1e-6 beyond */

/* Texels, row by row, j slow. Fits them to the reference. */
void tail_fit(double texels[TAIL_SIZE * TAIL_SIZE]);

/* Bilinear look-up of T in double, clamped to the edges. */
double tail_lookup(const double texels[TAIL_SIZE * TAIL_SIZE], double lambda, double c);

#endif
