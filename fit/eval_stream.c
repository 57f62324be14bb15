#include "fit/eval_stream.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/csv.h"
#include "base/json.h"
#include "base/options.h"
#include "base/text.h"
#include "fit/eval_block.h"

typedef struct stream {
    base_csv csv;
    evaluator *evaluator;
    const eval_format *format;
    block block;
    int lambda, angle; /* columns */
    char **names;      /* of the columns, quoted for JSON */
} stream;

/* Finds the columns and refuses one that has the name of a new one. */
static bool read_header(stream *s)
{
    s->lambda = base_csv_column(&s->csv, "lambda");
    int beta = base_csv_column(&s->csv, "beta");
    /* Where there are both, beta says more next to the poles. */
    s->angle = beta >= 0 ? beta : base_csv_column(&s->csv, "cos_theta");
    s->evaluator->by_beta = beta >= 0;
    if (s->lambda < 0 || s->angle < 0) {
        base_error("%s, line %ld: expected columns lambda and beta (or cos_theta), found no %s",
                   s->csv.name, s->csv.line, s->lambda < 0 ? "lambda" : "beta or cos_theta");
        return false;
    }
    const char *names[BLOCK_CELLS];
    size_t cells = block_cells(s->evaluator, s->format, names);
    for (size_t k = 0; k < cells; k++) {
        if (base_csv_column(&s->csv, names[k]) >= 0) {
            base_error("%s, line %ld: expected no column %s, which is what eval adds%s",
                       s->csv.name, s->csv.line, names[k],
                       k + 1 == cells ? " (--column gives it another name)" : "");
            return false;
        }
    }
    return true;
}

static bool quote_names(stream *s)
{
    s->names = calloc(s->csv.columns, sizeof *s->names);
    for (size_t i = 0; s->names && i < s->csv.columns; i++)
        if (!(s->names[i] = base_json_quote(s->csv.header[i])))
            return false;
    return s->names != NULL;
}

static void write_header(const stream *s)
{
    if (s->format->json) {
        putchar('[');
        return;
    }
    const char *names[BLOCK_CELLS];
    size_t cells = block_cells(s->evaluator, s->format, names);
    fputs(s->csv.row, stdout);
    for (size_t k = 0; k < cells; k++)
        printf(",%s", names[k]);
    putchar('\n');
}

/* The fields as members of an object: numbers as numbers, anything else as a string. */
static bool put_json_row(stream *s)
{
    for (size_t i = 0; i < s->csv.columns; i++) {
        char number[BASE_NUMBER_SIZE];
        double value;
        char *quoted = NULL;
        const char *text = number;
        if (base_parse_f64(s->csv.fields[i], s->csv.lengths[i], &value) && isfinite(value))
            base_shortest_f64(value, number);
        else if (!(text = quoted = base_json_quote(s->csv.fields[i])))
            return false;
        bool good = (i == 0 || block_put(&s->block, ", ", 2)) &&
                    block_put(&s->block, s->names[i], strlen(s->names[i])) &&
                    block_put(&s->block, ": ", 2) && block_put(&s->block, text, strlen(text));
        free(quoted);
        if (!good)
            return false;
    }
    return true;
}

/* 1 for a row taken, 0 at the end, else minus the exit status. */
static int take_row(stream *s)
{
    int status = base_csv_next(&s->csv);
    if (status <= 0)
        return status == 0 ? 0 : -BASE_USAGE;
    double lambda, angle;
    const char *expected;
    if (!base_csv_f64(&s->csv, s->lambda, &lambda))
        return -BASE_USAGE;
    if ((expected = evaluator_check_lambda(&lambda)) != NULL) {
        base_csv_error(&s->csv, s->lambda, expected);
        return -BASE_USAGE;
    }
    if (!base_csv_f64(&s->csv, s->angle, &angle))
        return -BASE_USAGE;
    if ((expected = evaluator_check_angle(s->evaluator, &angle)) != NULL) {
        base_csv_error(&s->csv, s->angle, expected);
        return -BASE_USAGE;
    }
    bool good =
        s->format->json ? put_json_row(s) : block_put(&s->block, s->csv.row, s->csv.row_length);
    return good && block_add(&s->block, lambda, angle) ? 1 : -BASE_FAILED;
}

static int run(stream *s)
{
    if (!read_header(s))
        return BASE_USAGE;
    if (!block_make(&s->block, s->evaluator, s->format) || (s->format->json && !quote_names(s)))
        return BASE_FAILED;
    write_header(s);
    int taken;
    while ((taken = take_row(s)) == 1)
        ;
    /* Standard output is a stream: what was good before a bad row is written. A failed write has
     * left nothing to flush. */
    if (taken != -BASE_FAILED && !block_flush(&s->block))
        return taken == 0 ? BASE_FAILED : -taken;
    if (taken != 0)
        return -taken;
    if (s->format->json)
        fputs("\n]\n", stdout);
    return BASE_DONE;
}

int eval_stream(evaluator *evaluator, const eval_format *format, FILE *in, const char *name)
{
    stream s = {.evaluator = evaluator, .format = format};
    int status = base_csv_open(&s.csv, in, name) ? run(&s) : BASE_USAGE;
    for (size_t i = 0; s.names && i < s.csv.columns; i++)
        free(s.names[i]);
    free(s.names);
    block_free(&s.block);
    base_csv_close(&s.csv);
    return status;
}

int eval_point(const evaluator *evaluator, const eval_format *format, double lambda, double angle)
{
    const char *angle_name = evaluator->by_beta ? "beta" : "cos_theta";
    char l[BASE_NUMBER_SIZE], a[BASE_NUMBER_SIZE], row[4 * BASE_NUMBER_SIZE];
    base_shortest_f64(lambda, l);
    base_shortest_f64(angle, a);
    if (format->json) {
        putchar('[');
        snprintf(row, sizeof row, "\"lambda\": %s, \"%s\": %s", l, angle_name, a);
    } else {
        const char *names[BLOCK_CELLS];
        size_t cells = block_cells(evaluator, format, names);
        printf("lambda,%s", angle_name);
        for (size_t k = 0; k < cells; k++)
            printf(",%s", names[k]);
        putchar('\n');
        snprintf(row, sizeof row, "%s,%s", l, a);
    }
    block b;
    bool good = block_make(&b, evaluator, format) && block_put(&b, row, strlen(row)) &&
                block_add(&b, lambda, angle) && block_flush(&b);
    block_free(&b);
    if (good && format->json)
        fputs("\n]\n", stdout);
    return good ? BASE_DONE : BASE_FAILED;
}
