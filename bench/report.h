/* report.h: the error report: what its sections share. Private to bench.
 *
 * A section is a row of the table in report.c: an id, a title and a function that writes it. */
#ifndef BENCH_REPORT_H
#define BENCH_REPORT_H

#include <stdbool.h>

#include "page.h"
#include "score.h"
#include "sg.h"

typedef struct report {
    page *page;
    size_t methods;                           /* of the registry, */
    score_result (*scores)[SCORE_PRECISIONS]; /* and their scores, in its order */
    double batch_speed_up; /* of sg_A_h_batch over single calls; 0: not measured */
    const char *bench;     /* folders that `sgfit bench` and */
    const char *stability; /* `sgfit stability` wrote; NULL: none given */
    const char *scenes;    /* folder that `sgfit bench --scenes` wrote; NULL: none given */
} report;

typedef struct report_section {
    const char *id, *title;
    bool (*write)(report *report);       /* false after one line on standard error */
    bool (*there)(const report *report); /* whether there is such a section; NULL: always */
} report_section;

/* The sections, each in the file that its comment names. */
bool report_headline(report *report);   /* report_headline.c */
bool report_accuracy(report *report);   /* report_accuracy.c */
bool report_cost(report *report);       /* report_cost.c */
bool report_float(report *report);      /* report_float.c */
bool report_curves(report *report);     /* figures_curves.c */
bool report_steepness(report *report);  /* figures_steepness.c */
bool report_rmse(report *report);       /* figures_rmse.c */
bool report_cosine(report *report);     /* figures_cosine.c */
bool report_hemisphere(report *report); /* figures_hemisphere.c */
bool report_fits(report *report);       /* report_fits.c */
bool report_routes(report *report);     /* report_routes.c */
bool report_formulas(report *report);   /* report_formulas.c */
bool report_machine(report *report);    /* report_machine.c */
bool report_stability(report *report);  /* report_stability.c */
bool report_has_stability(const report *report);
bool report_profile(report *report); /* report_profile.c */
bool report_has_profile(const report *report);
bool report_scenes(report *report); /* report_scenes.c */
bool report_has_scenes(const report *report);
bool report_tried(report *report); /* report_tried.c */
bool report_has_tried(const report *report);

/* report_maps.c: parts of report_stability. The failure maps; a CSV of the same folder as a table,
 * nothing where it is not there. */
bool report_maps(report *report);
void report_csv_table(report *report, const char *name, const char *caption);

/* report_readme.c: rewrites the block of figures in a README.md, and in tables/out beside it
 * chart.svg and, where scenes is the folder that `sgfit bench --scenes` wrote, the pictures of the
 * built-in scene. False after one line. */
bool report_readme(const char *path, const char *scenes);

/* `sgfit report`. */
int report_command(int argc, char **argv);

/* ---- report_models.c: which methods a figure shows ----------------------------------------- */

enum { REPORT_MODELS_MAX = 6 };

typedef struct report_model {
    const sg_method *method;
    bool ours; /* coefficients fitted here, rather than published */
} report_model;

/* The published model of that id, in its stable form where there is one (the same model, and
 * defined everywhere), then the refits of it that the registry holds. Returns how many. */
size_t report_family(const char *published, report_model models[REPORT_MODELS_MAX]);

/* Of such a family the published model, our least RMSE and our least maximum error (one, where they
 * are the same method); errors of L in double. Returns how many. */
size_t report_selection(const report *report, const char *published,
                        report_model models[REPORT_MODELS_MAX]);

/* A colour for the i-th of our own fits in a figure, apart from those of what is published there.
 */
int report_our_colour(size_t i);

/* Published constants that recipes fitted again, and how many of them lie within the relative
 * difference that their recipe promises. False after one line. report_constants.c */
bool report_fit_tally(size_t *constants, size_t *met);

/* The published method that this one continues, by its id ("ID_refit") or by its form; NULL where
 * there is none. */
const sg_method *report_published(const sg_method *method);

/* "id" of a published model's stable form is shown without its ending; else the id. */
const char *report_label(const report_model *model, char text[64]);

/* A coefficient of a method by name; NaN where the form has none of that name. */
double report_coefficient(const sg_method *method, const char *name);

/* Meder's curves c and s of a method: its A_h between its poles' exact values (eqs 15, 16). */
double report_c(const sg_method *method, double lambda, double cos_theta);
double report_s(const sg_method *method, double lambda, double cos_theta);

/* The steepness t and the height u of the logistic curve that the method's s follows. */
void report_logistic(const sg_method *method, double lambda, double *t, double *u);

/* i-th of n values, logarithmic from low to high. */
double report_logarithmic(double low, double high, size_t i, size_t n);

#endif
