/* methods_f64.c: every form and method in float. */
#define SG_PRECISION 32
#include "real.h"

#include "methods.h"

#include "../../tables/out/forms.inc"

#define SG_METHOD(ID, FORM, NATIVE, ...)                                                           \
    SG_COEFFICIENTS(ID, __VA_ARGS__)                                                               \
    SG_CORES(ID, FORM, NATIVE)                                                                     \
    SG_SINGLE(A_h, ID, float)                                                                      \
    SG_SINGLE(L, ID, float)                                                                        \
    SG_BATCH(A_h, ID)                                                                              \
    SG_BATCH(L, ID)
#include "../../tables/out/methods.inc"

#define SG_FORM_ROW(FORM, NATIVE, COUNT, ...) SG_FORM_FUNCTION(FORM)
#define SG_METHOD_ROW(ID, FORM, TITLE, SOURCE, YEAR, VARIANT, LAMBDA_MIN, LAMBDA_MAX)
#include "../../tables/out/registry.inc"
