/* chart_svg.c: the chart as a plain SVG, drawn by gnuplot; the names are placed here. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "chart.h"
#include "gnuplot.h"

const chart_look chart_looks[CHART_KINDS] = {
    [CHART_PUBLISHED] = {"published, as printed", 2, "circle", "●", 7},
    [CHART_STABLE] = {"published, made stable", 16, "rectRot", "◆", 13},
    [CHART_REFIT] = {"published form, refitted here", 3, "triangle", "▲", 9},
    [CHART_TIER] = {"form of our own", 1, "rect", "■", 5},
    [CHART_TABLE] = {"look-up table", 4, "triangle", "▼", 11},
};

/* Pixels, from the lower left corner as gnuplot counts. */
enum { WIDTH = 900, HEIGHT = 640, LEFT = 92, RIGHT = 880, BOTTOM = 112, TOP = 622 };
static const double letter = 6.7, line = 13.0; /* of the names, 12 pixels high */

typedef struct box {
    double x0, y0, x1, y1, weight; /* weight: how bad it is to cover it */
} box;

typedef struct scene {
    const chart *chart;
    double low[2], high[2]; /* log10 of cost, of error */
    box *taken;             /* points, then names */
    size_t boxes;
} scene;

static const chart_figure cost = CHART_INSTRUCTIONS, error = CHART_MAX;

static bool shown(const chart_point *p)
{
    return p->figure[cost] > 0.0 && !isinf(p->figure[cost]) && p->figure[error] > 0.0;
}

static double at_x(const scene *s, const chart_point *p)
{
    return LEFT + (RIGHT - LEFT) * (log10(p->figure[cost]) - s->low[0]) / (s->high[0] - s->low[0]);
}

/* What is infinite stands on the upper edge. */
static double at_y(const scene *s, const chart_point *p)
{
    double y = fmin(log10(p->figure[error]), s->high[1]);
    return BOTTOM + (TOP - BOTTOM) * (y - s->low[1]) / (s->high[1] - s->low[1]);
}

static void ranges(scene *s)
{
    for (int axis = 0; axis < 2; axis++) {
        s->low[axis] = (double)INFINITY;
        s->high[axis] = -(double)INFINITY;
        for (size_t i = 0; i < s->chart->count; i++) {
            const chart_point *p = &s->chart->points[i];
            double value = log10(p->figure[axis ? error : cost]);
            if (!shown(p) || isinf(value))
                continue;
            s->low[axis] = fmin(s->low[axis], value);
            s->high[axis] = fmax(s->high[axis], value);
        }
        if (s->low[axis] > s->high[axis])
            s->low[axis] = s->high[axis] = 0.0;
        s->low[axis] -= axis ? 0.25 : 0.12;
        s->high[axis] += axis ? 0.6 : 0.2;
    }
}

/* How much of a name at that place would cover something else, or stand outside. */
static double covered(const scene *s, box b)
{
    double sum = 0.0;
    if (b.x0 < LEFT + 2 || b.x1 > RIGHT + 12 || b.y0 < BOTTOM + 2 || b.y1 > TOP + 14)
        sum += 1e6;
    for (size_t i = 0; i < s->boxes; i++) {
        double w = fmin(b.x1, s->taken[i].x1) - fmax(b.x0, s->taken[i].x0);
        double h = fmin(b.y1, s->taken[i].y1) - fmax(b.y0, s->taken[i].y0);
        if (w > 0.0 && h > 0.0)
            sum += w * h * s->taken[i].weight;
    }
    return sum;
}

/* The nearest free place around a point, or where least is covered. */
static box place(const scene *s, double x, double y, double width)
{
    static const double away[] = {0, 10, 20, 32, 46, 62, 80};
    static const double turns[][2] = {{1, 0},      {-1, 0},      {0.7, 0.7}, {0.7, -0.7},
                                      {-0.7, 0.7}, {-0.7, -0.7}, {0, 1},     {0, -1}};
    box best = {0};
    double least = (double)INFINITY;
    for (size_t r = 0; r < sizeof away / sizeof *away; r++)
        for (size_t t = 0; t < sizeof turns / sizeof *turns; t++) {
            double cx = x + turns[t][0] * (10 + away[r]) +
                        (turns[t][0] > 0   ? 1
                         : turns[t][0] < 0 ? -1
                                           : 0) *
                            width / 2;
            double cy = y + turns[t][1] * (11 + away[r]);
            box b = {cx - width / 2, cy - line / 2, cx + width / 2, cy + line / 2, 1.0};
            double cover = covered(s, b) + (double)r * 2.0;
            if (cover < least) {
                least = cover;
                best = b;
            }
        }
    return best;
}

/* The front's steps, which names had better not stand on. */
static void add_steps(scene *s)
{
    size_t *front = calloc(s->chart->count + 1, sizeof *front);
    size_t count = front ? chart_front(s->chart, error, cost, front) : 0;
    for (size_t i = 0; i < count; i++) {
        const chart_point *p = &s->chart->points[front[i]];
        const chart_point *next = i + 1 < count ? &s->chart->points[front[i + 1]] : NULL;
        double x = at_x(s, p), y = at_y(s, p), to = next ? at_x(s, next) : RIGHT;
        s->taken[s->boxes++] = (box){x, y - 1, to, y + 1, 3.0};
        if (next)
            s->taken[s->boxes++] = (box){to - 1, at_y(s, next), to + 1, y, 3.0};
    }
    free(front);
}

static void name_points(FILE *out, scene *s)
{
    for (size_t i = 0; i < s->chart->count; i++) {
        const chart_point *p = &s->chart->points[i];
        if (!shown(p))
            continue;
        double x = at_x(s, p), y = at_y(s, p);
        s->taken[s->boxes++] = (box){x - 5, y - 5, x + 5, y + 5, 1.0};
    }
    add_steps(s);
    /* our own first: they are few, and what the chart is about */
    static const chart_kind order[] = {CHART_TIER, CHART_TABLE, CHART_PUBLISHED, CHART_REFIT,
                                       CHART_STABLE};
    for (size_t k = 0; k < CHART_KINDS; k++)
        for (size_t i = 0; i < s->chart->count; i++) {
            const chart_point *p = &s->chart->points[i];
            if (p->kind != order[k] || !shown(p))
                continue;
            char name[80];
            snprintf(name, sizeof name, "%s%s", p->id, isinf(p->figure[error]) ? " (∞)" : "");
            size_t letters = strlen(p->id) + (isinf(p->figure[error]) ? 4 : 0);
            double x = at_x(s, p), y = at_y(s, p);
            box b = place(s, x, y, letter * (double)letters);
            s->taken[s->boxes++] = b;
            double nx = fmin(fmax(x, b.x0), b.x1), ny = fmin(fmax(y, b.y0), b.y1);
            if (hypot(nx - x, ny - y) > 16.0)
                fprintf(out,
                        "set arrow from screen %.5f,%.5f to screen %.5f,%.5f nohead lw 0.6 lc "
                        "rgb \"#8a8f96\"\n",
                        x / WIDTH, y / HEIGHT, nx / WIDTH, ny / HEIGHT);
            fprintf(out, "set label \"%s\" at screen %.5f,%.5f center noenhanced font \",12\"\n",
                    name, (b.x0 + b.x1) / 2 / WIDTH, (b.y0 + b.y1) / 2 / HEIGHT);
        }
}

static void blocks(FILE *out, const scene *s)
{
    char x[BASE_NUMBER_SIZE], y[BASE_NUMBER_SIZE];
    double top = 0.9999 * pow(10.0, s->high[1]);
    for (int k = 0; k < CHART_KINDS; k++) {
        fprintf(out, "$kind%d << END\nNaN NaN\n", k);
        for (size_t i = 0; i < s->chart->count; i++) {
            const chart_point *p = &s->chart->points[i];
            if ((int)p->kind == k && shown(p))
                fprintf(out, "%s %s\n", base_shortest_f64(p->figure[cost], x),
                        base_shortest_f64(fmin(p->figure[error], top), y));
        }
        fputs("END\n", out);
    }
    size_t *front = calloc(s->chart->count + 1, sizeof *front);
    size_t count = front ? chart_front(s->chart, error, cost, front) : 0;
    fputs("$front << END\nNaN NaN\n", out);
    for (size_t i = 0; i < count; i++) {
        const double *f = s->chart->points[front[i]].figure;
        fprintf(out, "%s %s\n", base_shortest_f64(f[cost], x), base_shortest_f64(f[error], y));
        if (i + 1 == count)
            fprintf(out, "%.6g %s\n", pow(10.0, s->high[0]), y);
    }
    fputs("END\n", out);
    free(front);
}

static void axes(FILE *out, const scene *s, bool inside)
{
    fprintf(out,
            "set encoding utf8\nset terminal svg size %d,%d dynamic enhanced name \"chart\" font "
            "\"system-ui,sans-serif,14\"\n"
            "set border 3 lw 0.8\nset tics nomirror out scale 0.6\n"
            "set grid lw 0.6 dt 1 lc rgb \"gray\"\nset logscale xy\nset format y \"10^{%%T}\"\n"
            "set xtics (1,2,5,10,20,50,100,200,500,1000,2000,5000)\n"
            "set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\n"
            "set lmargin at screen %.5f\nset rmargin at screen %.5f\n"
            "set bmargin at screen %.5f\nset tmargin at screen %.5f\n"
            "set xlabel \"GPU instructions of one evaluation of L (navi21)\" noenhanced\n"
            "set ylabel \"largest error of L, float\" noenhanced\n",
            WIDTH, HEIGHT, pow(10.0, s->low[0]), pow(10.0, s->high[0]), pow(10.0, s->low[1]),
            pow(10.0, s->high[1]), (double)LEFT / WIDTH, (double)RIGHT / WIDTH,
            (double)BOTTOM / HEIGHT, (double)TOP / HEIGHT);
    fputs(inside
              ? "unset key\n"
              : "set key at screen 0.52,0.04 center center horizontal maxrows 2 samplen 1 width -6 "
                "Left reverse noenhanced font \",12\"\n",
          out);
}

char *chart_svg(const chart *chart, bool inside)
{
    scene s = {.chart = chart, .taken = calloc(4 * chart->count + 1, sizeof *s.taken)};
    char *script = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&script, &size);
    if (!out || !s.taken) {
        base_error("out of memory while drawing the chart");
        abort();
    }
    ranges(&s);
    axes(out, &s, inside);
    name_points(out, &s);
    blocks(out, &s);
    fprintf(out,
            "plot $front using 1:2 with steps lc rgb \"#%06x\" lw 1.5 dt (6,4) title \"front\"",
            10);
    for (int k = 0; k < CHART_KINDS; k++)
        fprintf(out,
                ", $kind%d using 1:2 with points pt %d ps %s lc rgb \"#%06x\" lw 2 title \"%s\"", k,
                chart_looks[k].gnuplot, k == CHART_TIER ? "0.9" : "0.75",
                (unsigned)chart_looks[k].colour, chart_looks[k].name);
    fputs("\n", out);
    fclose(out);
    free(s.taken);
    char *svg = gnuplot_run(script, size);
    free(script);
    char *adapted =
        svg ? gnuplot_adapt(svg, "chart_print",
                            "Largest error of L in float against GPU instructions", inside)
            : NULL;
    free(svg);
    return adapted;
}
