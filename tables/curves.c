/* curves.c: c and s over sharpness and angle, and the logistic's t and u over sharpness. */
#include "curves.h"

#include <math.h>
#include <stdio.h>

#include "base/text.h"
#include "sg.h"

enum { PER_DECADE = 5, FIRST = -3, DECADES = 7, ANGLES = 61 };

/* Five a decade, 1e-3 to 1e4, read from five digits: the same doubles on every machine. */
static double sharpness(int k)
{
    static const char *const mantissas[PER_DECADE] = {"1", "1.5849", "2.5119", "3.9811", "6.3096"};
    char text[BASE_NUMBER_SIZE];
    double value = 0;
    int length =
        snprintf(text, sizeof text, "%se%d", mantissas[k % PER_DECADE], k / PER_DECADE + FIRST);
    base_parse_f64(text, (size_t)length, &value);
    return value;
}

void curves_c_s(buffer *out)
{
    const double pi = 3.14159265358979323846;
    char lambda_text[BASE_NUMBER_SIZE], beta_text[BASE_NUMBER_SIZE];
    buffer_add(out, "lambda,beta,c,s\n");
    for (int k = -1; k <= PER_DECADE * DECADES; k++) {
        double lambda = k < 0 ? 0 : sharpness(k);
        base_shortest_f64(lambda, lambda_text);
        for (int j = 0; j < ANGLES; j++) {
            double beta = pi * j / (ANGLES - 1);
            buffer_print(out, "%s,%s,%.10f,%.10f\n", lambda_text,
                         base_shortest_f64(beta, beta_text), sg_c(lambda, beta),
                         sg_s(lambda, beta));
        }
    }
}

/* Normal equations of the linearised problem, and its sum of squares. */
typedef struct normal {
    double tt, tu, uu, t, u, squares;
} normal;

static normal linearise(const double *z, const double *s, double t, double u)
{
    normal sum = {0};
    for (int i = 0; i < CURVES_POINTS; i++) {
        double e = exp(-t * z[i]), sigmoid = e / (1 + e);
        double residual = u * sigmoid - s[i];
        double by_t = -u * z[i] * sigmoid / (1 + e), by_u = sigmoid;
        sum.tt += by_t * by_t;
        sum.tu += by_t * by_u;
        sum.uu += by_u * by_u;
        sum.t += by_t * residual;
        sum.u += by_u * residual;
        sum.squares += residual * residual;
    }
    return sum;
}

/* Gauss-Newton with halved steps; two parameters and a small residual need no more. */
bool curves_logistic(double lambda, double *t, double *u)
{
    double z[CURVES_POINTS], s[CURVES_POINTS];
    double reach = fmin(1.0, 6 / sqrt(lambda + 2));
    for (int i = 0; i < CURVES_POINTS; i++) {
        z[i] = reach * i / (CURVES_POINTS - 1);
        s[i] = sg_s_cos(lambda, z[i]);
    }
    normal at = linearise(z, s, *t, *u);
    for (int n = 0; n < 60; n++) {
        double determinant = at.tt * at.uu - at.tu * at.tu;
        double step_t = -(at.uu * at.t - at.tu * at.u) / determinant;
        double step_u = -(at.tt * at.u - at.tu * at.t) / determinant;
        double part = 1;
        normal next = linearise(z, s, *t + step_t, *u + step_u);
        while (!(next.squares <= at.squares * (1 + 1e-12)) && part > 1e-6) {
            part *= 0.5;
            next = linearise(z, s, *t + part * step_t, *u + part * step_u);
        }
        *t += part * step_t;
        *u += part * step_u;
        at = next;
        if (fabs(step_t) <= 1e-9 * fabs(*t) && fabs(step_u) <= 1e-9 * fabs(*u))
            return true;
    }
    return false;
}

bool curves_t_u(buffer *out)
{
    char number[BASE_NUMBER_SIZE];
    double t = 0.375 * sharpness(0), u = 2 - t; /* the limit at 0 */
    buffer_add(out, "lambda,t,u\n");
    for (int k = 0; k <= PER_DECADE * DECADES; k++) {
        double lambda = sharpness(k);
        if (!curves_logistic(lambda, &t, &u)) {
            base_error("the logistic curve does not converge at lambda %g", lambda);
            return false;
        }
        buffer_print(out, "%s,%.6e,%.6e\n", base_shortest_f64(lambda, number), t, u);
    }
    return true;
}
