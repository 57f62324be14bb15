/* quadrature.h: what the textbook routes share. Internal to libsg. */
#ifndef SG_QUADRATURE_H
#define SG_QUADRATURE_H

#include "sg.h"

/* Each route: SG_DOMAIN (and NaN as value) unless lambda is finite and >= 0 and beta in [0, pi]. */
sg_status sg_route_gauss_2d_64(double lambda, double beta, sg_quadrature *result);
sg_status sg_route_gauss_2d_256(double lambda, double beta, sg_quadrature *result);
sg_status sg_route_adaptive_2d(double lambda, double beta, sg_quadrature *result);
sg_status sg_route_bessel_1d(double lambda, double beta, sg_quadrature *result);
sg_status sg_route_ode_forward(double lambda, double beta, sg_quadrature *result);
sg_status sg_route_zonal_harmonics(double lambda, double beta, sg_quadrature *result);

/* Sets NaN, and zero evaluations; says whether the point is in the domain. */
int sg_route_begin(double lambda, double beta, sg_quadrature *result);

#endif
