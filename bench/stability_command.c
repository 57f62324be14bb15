/* stability_command.c: sgfit stability. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/options.h"
#include "base/text.h"
#include "smoothness.h"
#include "stability_private.h"

/* Sharpnesses to six significant digits, which is what bisection gives. */
static const char *number(double value, int digits, char text[BASE_NUMBER_SIZE])
{
    if (!isfinite(value))
        return base_shortest_f64(value, text);
    char rounded[BASE_NUMBER_SIZE];
    snprintf(rounded, sizeof rounded, "%.*g", digits, value);
    double shown;
    base_parse_f64(rounded, strlen(rounded), &shown);
    return base_shortest_f64(shown, text);
}

static bool write_failures(const stability_table *table, const char *path)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fputs("method,precision,kind,lambda_from,lambda_to,worst,worst_lambda,worst_cos_theta\n",
          output.stream);
    for (size_t i = 0; i < table->count; i++) {
        const stability_row *r = &table->rows[i];
        char text[5][BASE_NUMBER_SIZE];
        fprintf(output.stream, "%s,%s,%s,%s,%s,%s,%s,%s\n", r->method, r->precision, r->kind,
                number(r->lambda_from, 6, text[0]), number(r->lambda_to, 6, text[1]),
                number(r->worst, 7, text[2]), base_shortest_f64(r->worst_lambda, text[3]),
                base_shortest_f64(r->worst_cos_theta, text[4]));
    }
    return base_output_close(&output);
}

static bool write_half(const stability_result *result, const char *only, const char *path)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fputs("method,lambda_from,lambda_to\n", output.stream);
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *method = sg_method_at(i);
        double from, to;
        char text[2][BASE_NUMBER_SIZE];
        if (!method->L_f16 || (only && strcmp(only, method->id) != 0))
            continue;
        if (stability_half_range(&result->failures, method->id, &from, &to))
            fprintf(output.stream, "%s,%s,%s\n", method->id, number(from, 6, text[0]),
                    number(to, 6, text[1]));
        else
            fprintf(output.stream, "%s,,\n", method->id);
    }
    return base_output_close(&output);
}

bool stability_write(const stability_options *options, const stability_result *result)
{
    char *failures = base_join(options->out, "failures.csv");
    char *half = base_join(options->out, "half.csv");
    char *smooth = base_join(options->out, "smoothness.csv");
    bool good = write_failures(&result->failures, failures) &&
                write_half(result, options->only, half) && smoothness_write(options->only, smooth);
    free(failures);
    free(half);
    free(smooth);
    return good;
}

int stability_command(int argc, char **argv)
{
    stability_options run = {.device = "llvmpipe"};
    const base_usage usage = {
        "stability", "--out DIR [options]",
        "Finds where every method fails: scans sharpnesses from 0 to infinity and cosines in and "
        "slightly outside [-1, 1], in double, float, half and on a Vulkan device, and bisects the "
        "sharpnesses between which L is off by more than 1e-4, 1e-3 or 1e-2, negative, above 1, "
        "infinite or NaN. Writes DIR/failures.csv, DIR/half.csv, DIR/smoothness.csv and a map of "
        "the errors of each method and precision, DIR/maps/METHOD_PRECISION.exr and .png."};
    const base_option options[] = {
        {"out", BASE_STRING, &run.out, "DIR", "where the files go", NULL},
        {"method", BASE_STRING, &run.only, "ID", "this method alone", NULL},
        {"device", BASE_STRING, &run.device, "NAME",
         "part of the Vulkan device's name (default: llvmpipe, the software driver)", NULL},
        {"quick", BASE_FLAG, &run.quick, NULL, "fewer sharpnesses and cosines", NULL}};
    int status =
        base_parse_options(argc, argv, &usage, options, sizeof options / sizeof *options, NULL);
    if (status >= 0)
        return status;
    if (!run.out) {
        base_error("stability: expected --out DIR");
        return BASE_USAGE;
    }
    if (run.only && !sg_method_find(run.only)) {
        base_error("stability: expected --method to name a method (see sgfit methods), found %s",
                   run.only);
        return BASE_USAGE;
    }
    stability_result result;
    if (!stability_run(&run, &result))
        return BASE_FAILED;
    if (!result.device[0])
        fprintf(stderr, "sgfit: no rows for the device: %s\n", result.no_device);
    stability_result_free(&result);
    return BASE_DONE;
}
