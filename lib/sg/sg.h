/* sg.h: integrals of spherical Gaussians, exact and approximate.
 *
 * A spherical Gaussian (SG) of sharpness lambda and axis v is
 *     G(w) = exp(lambda (w.v - 1)),                                 amplitude 1 at w = v.
 * For a surface with unit normal n, beta is the angle between v and n, cos_theta = v.n = cos beta.
 *
 * Everything here depends on libm alone, keeps no state, starts no threads and may be called
 * from any number of threads at once.
 */
#ifndef SG_H
#define SG_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SG_VERSION "0.1.0"

typedef enum sg_status {
    SG_OK = 0,
    SG_DOMAIN,         /* an argument lies outside the stated domain */
    SG_NO_CONVERGENCE, /* an iteration ended without reaching its tolerance */
    SG_UNKNOWN         /* no such method, route or form */
} sg_status;

const char *sg_status_string(sg_status status);

/* ---- The reference ------------------------------------------------------------------------
 *
 * Domain: lambda in [0, inf], beta in [0, pi] (radians); lambda = +inf gives the limit.
 * cos_theta variants take v.n and treat values beyond [-1, 1] as -1 and 1, because dot products
 * of unit vectors round. Anything else (negative lambda, beta outside, NaN) gives NaN.
 * Relative error at most 2e-14 where the value is above 1e-20 and at most 2e-13 where it is
 * above 1e-250; s: absolute 1e-12. Checked against rigorous enclosures (tests/test_certified.c),
 * where no error above 2e-15 of the value was found, and none above 4e-16 for s.
 */
double sg_A(double lambda);   /* integral of G over the sphere: 2 pi (1 - e^-2lambda)/lambda */
double sg_A_u(double lambda); /* A_h at beta = 0:  2 pi (e^-lambda - 1 + lambda)/lambda^2 */
double sg_A_b(double lambda); /* at beta = pi: 2 pi e^-2lambda (e^lambda - 1 - lambda)/lambda^2 */

/* A_h: integral of G(w) max(w.n, 0) over the sphere, in [0, pi] (Meder and Bruederlin, eq. 12). */
double sg_A_h(double lambda, double beta);
double sg_A_h_cos(double lambda, double cos_theta);

/* H: integral of G over the hemisphere of n, in [0, 2 pi]. */
double sg_H(double lambda, double beta);
double sg_H_cos(double lambda, double cos_theta);

/* L = A_h/A: the same as A_h for a lobe that integrates to 1 (von Mises-Fisher), in [0, 1]. */
double sg_L(double lambda, double beta);
double sg_L_cos(double lambda, double cos_theta);

/* c: A_h between its values at the poles, (A_h - A_b)/(A_u - A_b), in [0, 1] (Meder, eq. 15). */
double sg_c(double lambda, double beta);
double sg_c_cos(double lambda, double cos_theta);

/* s: c between the clamped and the normalised cosine (Meder, eq. 16 solved for s), in [0, 1].
 * At lambda = 0 and at beta = 0 and pi, where eq. 16 reads 0/0, the limit. */
double sg_s(double lambda, double beta);
double sg_s_cos(double lambda, double cos_theta);

/* A_h at n points; out may not overlap the inputs. To the bit what n single calls answer, faster:
 * points are taken 32 at a time, with AVX2 where the processor has it (tests/test_batch.c prints
 * the rates; about 1.8 times there, little more than 1 without AVX2). */
void sg_A_h_batch(size_t n, const double *lambda, const double *beta, double *out);
void sg_A_h_cos_batch(size_t n, const double *lambda, const double *cos_theta, double *out);
void sg_L_cos_batch(size_t n, const double *lambda, const double *cos_theta, double *out);

/* ---- Textbook quadrature of A_h, kept to be measured ----------------------------------------
 *
 * Each route claims an error of its own; where that claim is wrong is what the report shows. */
typedef struct sg_quadrature {
    double value;         /* A_h as the route has it */
    double claimed_error; /* absolute error that the route itself claims */
    long evaluations;     /* evaluations of the integrand (or right-hand side, or terms) */
} sg_quadrature;

typedef struct sg_route {
    const char *id;    /* "gauss_2d_64", "gauss_2d_256", "adaptive_2d", "bessel_1d", "ode_forward",
                          "zonal_harmonics" */
    const char *title; /* one line for people */
    sg_status (*A_h)(double lambda, double beta, sg_quadrature *result);
} sg_route;

size_t sg_route_count(void);
const sg_route *sg_route_at(size_t index);
const sg_route *sg_route_find(const char *id); /* NULL where there is none */

/* ---- Lobes ------------------------------------------------------------------------------- */

typedef struct sg_lobe {
    double axis[3];   /* unit vector */
    double sharpness; /* lambda, in [0, inf) */
    double amplitude; /* value at the axis */
} sg_lobe;

/* amplitude exp(sharpness (direction.axis - 1)), accurate next to the axis at any sharpness;
 * direction is a unit vector. */
double sg_lobe_evaluate(const sg_lobe *lobe, const double direction[3]);

/* Integral over the sphere. */
double sg_lobe_integral(const sg_lobe *lobe);

/* Irradiance on a surface with unit normal: the reference A_h times the amplitude. */
double sg_lobe_irradiance(const sg_lobe *lobe, const double normal[3]);

/* The product of two lobes, a lobe again (Xu et al. 2014). Never cancels; where the product has
 * sharpness 0 (opposite axes of equal sharpness) its axis is a unit vector perpendicular to both.
 */
sg_lobe sg_lobe_product(const sg_lobe *a, const sg_lobe *b);

/* Mean resultant length r in [0, 1] of a normalised lobe from its sharpness, coth(lambda) -
 * 1/lambda, and sharpness from r. r >= 1 gives +inf, r <= 0 gives 0, NaN gives NaN. */
double sg_mean_from_sharpness(double lambda);          /* exact */
double sg_sharpness_from_mean(double r);               /* its exact inverse */
double sg_mean_from_sharpness_toksvig(double lambda);  /* lambda/(1 + lambda) */
double sg_sharpness_from_mean_toksvig(double r);       /* r/(1 - r), Meder eq. 4 */
double sg_mean_from_sharpness_banerjee(double lambda); /* root of the next in [0, 1] */
double sg_sharpness_from_mean_banerjee(double r);      /* r (3 - r^2)/(1 - r^2), Banerjee 2005 */

/* The lobe of a set of directions with weights: sum of weight*direction and sum of weight in,
 * a lobe with that mean direction and that integral out (Meder, eqs 4 and 5), its sharpness by
 * the rule given (NULL: the exact inverse). A zero sum of vectors gives sharpness 0 and axis +z.
 * sharpness is limited to max_sharpness (0: no limit), because one light alone would give an
 * infinite one, and with it an infinite amplitude. */
typedef double (*sg_sharpness_rule)(double r);
sg_lobe sg_lobe_from_moments(const double vector_sum[3], double weight_sum, sg_sharpness_rule rule,
                             double max_sharpness);

/* a*b - c*d with an error of about one rounding (Kahan 2004). */
double sg_difference_of_products(double a, double b, double c, double d);

/* ---- The registry of approximations -------------------------------------------------------
 *
 * Generated from tables/constants by `sgfit emit`. A form is a formula with free coefficients,
 * a method is a form with its coefficients. All take (lambda, cos_theta), cos_theta = v.n.
 * f16 functions take and return float, but compute in IEEE half at every step: arguments are
 * rounded to half first. Domains, errors and sources: the method's record. */
typedef enum sg_quantity { SG_A_H, SG_L } sg_quantity;

typedef struct sg_form {
    const char *id;
    sg_quantity native; /* what the text computes */
    int coefficient_count;
    const char *const *coefficient_names;
    double (*f64)(double lambda, double cos_theta, const double *coefficients);
    float (*f32)(float lambda, float cos_theta, const float *coefficients);
    float (*f16)(float lambda, float cos_theta, const float *coefficients);
} sg_form;

size_t sg_form_count(void);
const sg_form *sg_form_at(size_t index);
const sg_form *sg_form_find(const char *id);

typedef struct sg_method {
    const char *id;
    const char *title;
    const char *source; /* paper and equation, or the recipe that made it */
    int year;
    const char *variant; /* "published", "stable", "refit" or "tier" */
    const sg_form *form;
    double lambda_min, lambda_max; /* domain; lambda_max may be infinite */
    const double *coefficients;    /* form->coefficient_count of them */
    double (*A_h_f64)(double lambda, double cos_theta);
    double (*L_f64)(double lambda, double cos_theta);
    float (*A_h_f32)(float lambda, float cos_theta);
    float (*L_f32)(float lambda, float cos_theta);
    float (*A_h_f16)(float lambda, float cos_theta);
    float (*L_f16)(float lambda, float cos_theta);
    /* n points; out may not overlap the inputs; vectorised where the machine can */
    void (*A_h_batch_f64)(size_t n, const double *lambda, const double *cos_theta, double *out);
    void (*L_batch_f64)(size_t n, const double *lambda, const double *cos_theta, double *out);
    void (*A_h_batch_f32)(size_t n, const float *lambda, const float *cos_theta, float *out);
    void (*L_batch_f32)(size_t n, const float *lambda, const float *cos_theta, float *out);
} sg_method;

size_t sg_method_count(void);
const sg_method *sg_method_at(size_t index);
const sg_method *sg_method_find(const char *id);

#ifdef __cplusplus
}
#endif

#endif
