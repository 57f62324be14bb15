/* methods_f32.c: every form and method in float. */
#define SG_PRECISION 32
#include "real.h"

#include "methods.h"

#include "../../tables/out/forms.inc"

SG_BATCH_CONVERSION(A_h, L)
SG_BATCH_CONVERSION(L, A_h)

#define SG_METHOD(ID, FORM, NATIVE, ...)                                                           \
    SG_COEFFICIENTS(ID, __VA_ARGS__)                                                               \
    SG_SINGLES_##NATIVE(ID, FORM, float) SG_BATCHES_##NATIVE(ID, FORM)
#include "../../tables/out/methods.inc"

#define SG_FORM_ROW(FORM, NATIVE, COUNT, ...) SG_FORM_FUNCTION(FORM)
#define SG_METHOD_ROW(ID, FORM, TITLE, SOURCE, YEAR, VARIANT, LAMBDA_MIN, LAMBDA_MAX)
#include "../../tables/out/registry.inc"
