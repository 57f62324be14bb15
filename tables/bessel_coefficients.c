/* bessel_coefficients: writes lib/sg/bessel_table.inc, the only generated numbers of the reference
 * integral, to standard output. Needs FLINT/Arb; the library itself does not.
 *
 *     bessel_coefficients > lib/sg/bessel_table.inc
 *
 * Two functions of x in [0, inf), in r = 1/(x + 8), which runs through (0, 1/8]:
 *     even(r) = r^-5/2 e^-x (I0(x) - I1(x)/x - 1/2)/x^2      the source of A_h, less its pole value
 *     odd(r)  = r^-3/2 e^-x I1(x)/x                          the source of H
 * Both are smooth up to and including r = 0. The range is cut into 32 equal pieces; on each the
 * function is interpolated at 9 Chebyshev nodes and written as a polynomial of degree 8 in
 * y in [-1, 1] across the piece. The first neglected Chebyshev coefficient is printed per function.
 * Then the 24 Gauss-Legendre nodes and weights of [0, 1]. */
#include <arb.h>
#include <arb_hypgeom.h>
#include <arb_poly.h>
#include <math.h>
#include <stdio.h>

enum { bits = 600, shift = 8, pieces = 32, degree = 8, nodes = 24 };

static double nearest(const arb_t value)
{
    return arf_get_d(arb_midref(value), ARF_RND_NEAR);
}

static void sample(arb_t out, const arb_t r, int odd)
{
    arb_t x, order, i0, i1, half;
    arb_init(x), arb_init(order), arb_init(i0), arb_init(i1), arb_init(half);
    arb_inv(x, r, bits);
    arb_sub_si(x, x, shift, bits);
    arb_zero(order);
    arb_hypgeom_bessel_i_scaled(i0, order, x, bits);
    arb_one(order);
    arb_hypgeom_bessel_i_scaled(i1, order, x, bits);
    arb_div(i1, i1, x, bits);
    if (odd) {
        arb_set(out, i1);
    } else {
        arb_neg(half, x);
        arb_exp(half, half, bits);
        arb_mul_2exp_si(half, half, -1);
        arb_sub(out, i0, i1, bits);
        arb_sub(out, out, half, bits);
        arb_div(out, out, x, bits);
        arb_div(out, out, x, bits);
    }
    arb_set_si(order, odd ? 3 : 5);
    arb_mul_2exp_si(order, order, -1);
    arb_pow(order, r, order, bits);
    arb_div(out, out, order, bits);
    arb_clear(x), arb_clear(order), arb_clear(i0), arb_clear(i1), arb_clear(half);
}

/* The polynomial in y through the Chebyshev nodes of one piece, and the size of the first
 * Chebyshev coefficient that it leaves out, relative to the mean. */
static double interpolate(arb_poly_t polynomial, int piece, int odd)
{
    enum { count = degree + 2 };
    arb_t y, r, value[count], sum, weight;
    arb_poly_t chebyshev;
    arb_init(y), arb_init(r), arb_init(sum), arb_init(weight);
    arb_poly_init(chebyshev);
    arb_poly_zero(polynomial);
    for (int k = 0; k < count; k++) {
        arb_init(value[k]);
        arb_set_si(y, 2 * k + 1);
        arb_div_si(y, y, 2 * count, bits);
        arb_cos_pi(y, y, bits);
        arb_add_si(r, y, 2 * piece + 1, bits);
        arb_div_si(r, r, 2L * pieces * shift, bits);
        sample(value[k], r, odd);
    }
    double mean = 0.0, neglected = 0.0;
    for (int j = 0; j < count; j++) {
        arb_zero(sum);
        for (int k = 0; k < count; k++) {
            arb_set_si(weight, (long)j * (2 * k + 1));
            arb_div_si(weight, weight, 2 * count, bits);
            arb_cos_pi(weight, weight, bits);
            arb_addmul(sum, weight, value[k], bits);
        }
        arb_mul_si(sum, sum, j == 0 ? 1 : 2, bits);
        arb_div_si(sum, sum, count, bits);
        if (j == 0)
            mean = nearest(sum);
        if (j == degree + 1) {
            neglected = fabs(nearest(sum) / mean);
            break;
        }
        fmpz_poly_t exact;
        fmpz_poly_init(exact);
        fmpz_poly_chebyshev_t(exact, (ulong)j);
        arb_poly_set_fmpz_poly(chebyshev, exact, bits);
        fmpz_poly_clear(exact);
        arb_poly_scalar_mul(chebyshev, chebyshev, sum, bits);
        arb_poly_add(polynomial, polynomial, chebyshev, bits);
    }
    for (int k = 0; k < count; k++)
        arb_clear(value[k]);
    arb_clear(y), arb_clear(r), arb_clear(sum), arb_clear(weight);
    arb_poly_clear(chebyshev);
    return neglected;
}

/* One row for each power of y, one column for each piece. */
static void write_function(const char *name, int odd)
{
    static double table[degree + 1][pieces];
    arb_poly_t polynomial;
    arb_t coefficient;
    double worst = 0.0;
    arb_poly_init(polynomial);
    arb_init(coefficient);
    for (int piece = 0; piece < pieces; piece++) {
        double neglected = interpolate(polynomial, piece, odd);
        worst = neglected > worst ? neglected : worst;
        for (int i = 0; i <= degree; i++) {
            arb_poly_get_coeff_arb(coefficient, polynomial, i);
            table[i][piece] = nearest(coefficient);
        }
    }
    printf("/* first neglected Chebyshev coefficient: at most %.1e of the mean */\n", worst);
    printf("static const double %s[SG_BESSEL_DEGREE + 1][SG_BESSEL_PIECES] = {\n", name);
    for (int i = 0; i <= degree; i++) {
        printf("    {");
        for (int piece = 0; piece < pieces; piece++)
            printf("%s%.17g", piece % 4 ? ", " : piece ? ",\n     " : "", table[i][piece]);
        printf("},\n");
    }
    printf("};\n\n");
    arb_poly_clear(polynomial);
    arb_clear(coefficient);
}

static void write_gauss(int want_weights)
{
    arb_t node, weight;
    arb_init(node), arb_init(weight);
    printf("static const double sg_gauss_%s[SG_GAUSS_NODES] = {", want_weights ? "weight" : "node");
    for (int k = 0; k < nodes; k++) {
        /* the k-th root counts from +1 downwards */
        arb_hypgeom_legendre_p_ui_root(node, weight, nodes, (ulong)(nodes - 1 - k), bits);
        arb_add_si(node, node, 1, bits);
        arb_mul_2exp_si(node, node, -1);
        arb_mul_2exp_si(weight, weight, -1);
        printf("%s%.17g,", k % 4 ? " " : "\n    ", nearest(want_weights ? weight : node));
    }
    printf("\n};\n");
    arb_clear(node), arb_clear(weight);
}

int main(void)
{
    printf("/* Generated by tables/bessel_coefficients.c, which says what these numbers are. */\n"
           "/* clang-format off */\n"
           "enum {\n    SG_BESSEL_SHIFT = %d,\n    SG_BESSEL_PIECES = %d,\n"
           "    SG_BESSEL_DEGREE = %d,\n    SG_GAUSS_NODES = %d\n};\n\n",
           shift, pieces, degree, nodes);
    write_function("sg_bessel_even", 0);
    write_function("sg_bessel_odd", 1);
    write_gauss(0);
    printf("\n");
    write_gauss(1);
    printf("/* clang-format on */\n");
    flint_cleanup();
    return ferror(stdout) || fflush(stdout) ? 1 : 0;
}
