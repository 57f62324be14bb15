/* stability_long.c: every method once more in long double, to tell what double's rounding does to a
 * text from what its model does. */
#include <float.h>
#include <string.h>

#include "stability_private.h"

#if LDBL_MANT_DIG > DBL_MANT_DIG

#define SG_PRECISION 80
#include "../lib/sg/real.h"

#include "../lib/sg/methods.h"

#include "../tables/out/forms.inc"

#define SG_L_FROM_L(value, lambda, cos_theta) (value)

#define SG_METHOD(ID, FORM, NATIVE, ...)                                                           \
    SG_COEFFICIENTS(ID, __VA_ARGS__)                                                               \
    static double long_##ID(double lambda, double cos_theta)                                       \
    {                                                                                              \
        SG_REAL value = SG_NAME(form_##FORM)((SG_REAL)lambda, (SG_REAL)cos_theta,                  \
                                             SG_NAME(sg_coefficients_##ID));                       \
        return (double)SG_L_FROM_##NATIVE(value, (SG_REAL)lambda, (SG_REAL)cos_theta);             \
    }
#include "../tables/out/methods.inc"
#undef SG_METHOD

static const struct {
    const char *id;
    double (*L)(double, double);
} methods[] = {
#define SG_METHOD(ID, FORM, NATIVE, ...) {#ID, long_##ID},
#include "../tables/out/methods.inc"
};

double (*stability_long_L(const char *id))(double, double)
{
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++)
        if (strcmp(methods[i].id, id) == 0)
            return methods[i].L;
    return NULL;
}

#else

double (*stability_long_L(const char *id))(double, double)
{
    (void)id;
    return NULL;
}

#endif
