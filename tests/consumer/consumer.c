/* consumer.c: one call from each part of the installed library, and what it must answer. */
#include <math.h>
#include <sg.h>
#include <stdio.h>
#include <string.h>

int header_compiles_as_cxx(void);

static int check(const char *what, double found, double expected)
{
    if (fabs(found - expected) <= 1e-15 * fabs(expected))
        return 0;
    fprintf(stderr, "%s: found %.17g, expected %.17g\n", what, found, expected);
    return 1;
}

int main(void)
{
    int failures = 0;
    const sg_lobe lobe = {{0.0, 0.0, 1.0}, 0.0, 2.0};
    const double normal[3] = {0.0, 0.6, 0.8};
    double lambda = 3.0, cos_theta = 0.25, batch;
    sg_A_h_cos_batch(1, &lambda, &cos_theta, &batch);
    failures += check("sg_lobe_irradiance", sg_lobe_irradiance(&lobe, normal), 6.2831853071795865);
    failures += check("sg_A_h_cos_batch", batch, sg_A_h_cos(lambda, cos_theta));
    failures += check("sg_sharpness_from_mean_toksvig", sg_sharpness_from_mean_toksvig(0.5), 1.0);
    failures += sg_route_find("bessel_1d") == NULL;
    failures += sg_method_find("meder_2018") == NULL;
    failures += strcmp(sg_status_string(SG_OK), "success") != 0;
    failures += header_compiles_as_cxx() != 0;
    return failures;
}
