/* method.c: the registry, assembled from the generated lists. */
#include "sg.h"

#include <math.h>
#include <string.h>

#include "methods.h"

/* The functions that methods_*.c stamp. */
#define SG_DECLARE_SINGLE(QUANTITY, ID)                                                            \
    SG_HIDDEN double sg_##QUANTITY##_##ID##_f64(double lambda, double cos_theta);                  \
    SG_HIDDEN float sg_##QUANTITY##_##ID##_f32(float lambda, float cos_theta);                     \
    SG_HIDDEN float sg_##QUANTITY##_##ID##_f16(float lambda, float cos_theta);                     \
    SG_HIDDEN void sg_##QUANTITY##_batch_##ID##_f64(size_t n, const double *restrict lambda,       \
                                                    const double *restrict cos_theta,              \
                                                    double *restrict out);                         \
    SG_HIDDEN void sg_##QUANTITY##_batch_##ID##_f32(size_t n, const float *restrict lambda,        \
                                                    const float *restrict cos_theta,               \
                                                    float *restrict out);

#define SG_FORM_ROW(FORM, NATIVE, COUNT, ...)                                                      \
    SG_HIDDEN double sg_form_##FORM##_f64(double lambda, double cos_theta, const double *k);       \
    SG_HIDDEN float sg_form_##FORM##_f32(float lambda, float cos_theta, const float *k);           \
    SG_HIDDEN float sg_form_##FORM##_f16(float lambda, float cos_theta, const float *k);           \
    static const char *const names_##FORM[] = {__VA_ARGS__};
#define SG_METHOD_ROW(ID, FORM, TITLE, SOURCE, YEAR, VARIANT, LAMBDA_MIN, LAMBDA_MAX)              \
    SG_HIDDEN extern const double sg_coefficients_##ID##_f64[];                                    \
    SG_DECLARE_SINGLE(A_h, ID)                                                                     \
    SG_DECLARE_SINGLE(L, ID)
#include "../../tables/out/registry.inc"
#undef SG_FORM_ROW
#undef SG_METHOD_ROW

#define SG_FORM_ROW(FORM, NATIVE, COUNT, ...) form_index_##FORM,
#define SG_METHOD_ROW(ID, FORM, TITLE, SOURCE, YEAR, VARIANT, LAMBDA_MIN, LAMBDA_MAX)
enum {
#include "../../tables/out/registry.inc"
    form_total
};
#undef SG_FORM_ROW
#undef SG_METHOD_ROW

#ifdef SG_HAVE_F16
#define F16(function) function
#else
#define F16(function) NULL
#endif

/* The last row ends each table, so that neither is ever empty. */
#define SG_FORM_ROW(FORM, NATIVE, COUNT, ...)                                                      \
    {#FORM,                                                                                        \
     SG_NATIVE_##NATIVE,                                                                           \
     COUNT,                                                                                        \
     names_##FORM,                                                                                 \
     sg_form_##FORM##_f64,                                                                         \
     sg_form_##FORM##_f32,                                                                         \
     F16(sg_form_##FORM##_f16)},
#define SG_METHOD_ROW(ID, FORM, TITLE, SOURCE, YEAR, VARIANT, LAMBDA_MIN, LAMBDA_MAX)
static const sg_form forms[] = {
#include "../../tables/out/registry.inc"
    {NULL, SG_A_H, 0, NULL, NULL, NULL, NULL},
};
#undef SG_FORM_ROW
#undef SG_METHOD_ROW

#define SG_FORM_ROW(FORM, NATIVE, COUNT, ...)
#define SG_METHOD_ROW(ID, FORM, TITLE, SOURCE, YEAR, VARIANT, LAMBDA_MIN, LAMBDA_MAX)              \
    {.id = #ID,                                                                                    \
     .title = TITLE,                                                                               \
     .source = SOURCE,                                                                             \
     .year = YEAR,                                                                                 \
     .variant = VARIANT,                                                                           \
     .form = &forms[form_index_##FORM],                                                            \
     .lambda_min = LAMBDA_MIN,                                                                     \
     .lambda_max = LAMBDA_MAX,                                                                     \
     .coefficients = sg_coefficients_##ID##_f64,                                                   \
     .A_h_f64 = sg_A_h_##ID##_f64,                                                                 \
     .L_f64 = sg_L_##ID##_f64,                                                                     \
     .A_h_f32 = sg_A_h_##ID##_f32,                                                                 \
     .L_f32 = sg_L_##ID##_f32,                                                                     \
     .A_h_f16 = F16(sg_A_h_##ID##_f16),                                                            \
     .L_f16 = F16(sg_L_##ID##_f16),                                                                \
     .A_h_batch_f64 = sg_A_h_batch_##ID##_f64,                                                     \
     .L_batch_f64 = sg_L_batch_##ID##_f64,                                                         \
     .A_h_batch_f32 = sg_A_h_batch_##ID##_f32,                                                     \
     .L_batch_f32 = sg_L_batch_##ID##_f32},
static const sg_method methods[] = {
#include "../../tables/out/registry.inc"
    {.id = NULL},
};

size_t sg_form_count(void)
{
    return sizeof forms / sizeof forms[0] - 1;
}

const sg_form *sg_form_at(size_t index)
{
    return index < sg_form_count() ? &forms[index] : NULL;
}

const sg_form *sg_form_find(const char *id)
{
    for (const sg_form *form = forms; id && form->id; form++) {
        if (strcmp(form->id, id) == 0)
            return form;
    }
    return NULL;
}

size_t sg_method_count(void)
{
    return sizeof methods / sizeof methods[0] - 1;
}

const sg_method *sg_method_at(size_t index)
{
    return index < sg_method_count() ? &methods[index] : NULL;
}

const sg_method *sg_method_find(const char *id)
{
    for (const sg_method *method = methods; id && method->id; method++) {
        if (strcmp(method->id, id) == 0)
            return method;
    }
    return NULL;
}
