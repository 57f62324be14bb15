/* stability_cores.h: the lobe operations at one precision, as values that the scan can judge: the
 * stable helpers of shaders/forms/helpers beside what the papers print. */
#ifndef BENCH_STABILITY_CORES_H
#define BENCH_STABILITY_CORES_H

#include <stdbool.h>

/* Two lobes of amplitude 1 and sharpness lambda, their axes at cos_theta; value and truth are of
 * the same quantity: product_sharpness   of the product, over the sum of both sharpnesses; in [0,
 * 1] product_amplitude   of the product, in [0, 1] product_axis        cosine between the product's
 * axis and the first lobe's, in [0, 1] product_integral    of the product over the sphere, over
 * that of one lobe; in [0, 1] Moments, one number in [0, 1] for the mean of a normalised lobe of
 * sharpness lambda, rounded to the precision; the truth is 1: sharpness_toksvig, sharpness_banerjee
 * the rule's sharpness of that number, over lambda One light of weight lambda in a direction at
 * cos_theta to the z axis; printed has no truth: sharpness_one_light   by Toksvig's rule, over the
 * limit of 1e4 that the stable one has Ids of what the papers print end in _printed. */
typedef struct stability_core {
    const char *id;
    double (*value)(double lambda, double cos_theta);
    double (*truth)(double lambda, double cos_theta); /* NULL: none */
    bool in_unit;                                     /* the truth lies in [0, 1] */
} stability_core;

/* Each ends with an id of NULL; in half it is empty where the compiler has none. */
extern const stability_core stability_cores_f64[], stability_cores_f32[], stability_cores_f16[];

/* stability_truths.c: in long double. */
double truth_product_sharpness(double lambda, double cos_theta);
double truth_product_amplitude(double lambda, double cos_theta);
double truth_product_axis(double lambda, double cos_theta);
double truth_product_integral(double lambda, double cos_theta);
double truth_one(double lambda, double cos_theta);

#endif
