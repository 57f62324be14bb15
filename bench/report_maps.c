/* report_maps.c: the failure maps in the page, and tables that are shown as their CSV has them. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/csv.h"
#include "base/file.h"
#include "base/text.h"
#include "html.h"
#include "report.h"
#include "stability.h"

static void base64(FILE *out, const unsigned char *bytes, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < size; i += 3) {
        size_t left = size - i < 3 ? size - i : 3;
        unsigned word = (unsigned)bytes[i] << 16;
        if (left > 1)
            word |= (unsigned)bytes[i + 1] << 8;
        if (left > 2)
            word |= (unsigned)bytes[i + 2];
        for (size_t d = 0; d < 4; d++)
            fputc(d <= left ? digits[word >> (18 - 6 * d) & 63] : '=', out);
    }
}

/* A map that is not there is one that was not made: of the device, where there is none. */
static bool map(report *report, const sg_method *method, const char *precision)
{
    char name[160];
    snprintf(name, sizeof name, "maps/%s_%s.png", method->id, precision);
    char *path = base_join(report->stability, name), *bytes = NULL;
    size_t size = 0;
    bool there = access(path, R_OK) == 0;
    if (there)
        bytes = base_read_file(path, &size);
    free(path);
    if (!bytes)
        return !there;
    FILE *out = page_html(report->page);
    fprintf(out,
            "<figure><img width=\"%d\" height=\"%d\" alt=\"Errors of %s in %s over sharpness "
            "and angle\" src=\"data:image/png;base64,",
            STABILITY_MAP_WIDTH, STABILITY_MAP_HEIGHT, method->id, precision);
    base64(out, (const unsigned char *)bytes, size);
    fprintf(out, "\"><figcaption><code>%s</code></figcaption></figure>\n", method->id);
    free(bytes);
    return true;
}

static void legend(FILE *out)
{
    static const char *const marks[STABILITY_MARKS] = {NULL, "negative", "above 1", "infinite",
                                                       "NaN"};
    uint8_t c[3];
    fputs("<ul class=\"legend\">\n", out);
    for (int e = -8; e <= 0; e += 2) {
        stability_color(e, STABILITY_FINE, c);
        fprintf(out, "<li><span style=\"color:#%02x%02x%02x\">■</span>1e%d</li>\n", c[0], c[1],
                c[2], e);
    }
    for (int m = STABILITY_NEGATIVE; m < STABILITY_MARKS; m++) {
        stability_color(0, (stability_mark)m, c);
        fprintf(out, "<li><span style=\"color:#%02x%02x%02x\">■</span>%s</li>\n", c[0], c[1], c[2],
                marks[m]);
    }
    fputs("</ul>\n", out);
}

bool report_maps(report *report)
{
    static const char *const titles[STABILITY_PRECISIONS] = {"double", "float", "half",
                                                             "the Vulkan device"};
    FILE *out = page_html(report->page);
    html_paragraph(report->page,
                   "Failure maps: from left to right the sharpness, logarithmic from %g to %g; "
                   "downwards the angle β from 0 to π. Colours are the error of L.",
                   stability_map_lambda_min, stability_map_lambda_max);
    legend(out);
    bool done = true;
    for (int p = 0; p < STABILITY_PRECISIONS && done; p++) {
        fprintf(out, "<details%s><summary>Maps in %s</summary>\n<div class=\"maps\">\n",
                p == STABILITY_F32 ? " open" : "", titles[p]);
        for (size_t i = 0; i < report->methods && done; i++)
            done = map(report, sg_method_at(i), stability_precision_name((stability_precision)p));
        fputs("</div></details>\n", out);
    }
    return done;
}

static void cells(report *report, const base_csv *csv)
{
    html_row_begin(report->page, NULL);
    for (size_t c = 0; c < csv->columns; c++) {
        double value;
        if (csv->lengths[c] && base_parse_f64(csv->fields[c], csv->lengths[c], &value))
            html_cell_number(report->page, value, 3);
        else
            html_cell(report->page, csv->fields[c]);
    }
    html_row_end(report->page);
}

void report_csv_table(report *report, const char *name, const char *caption)
{
    char *path = base_join(report->stability, name);
    FILE *stream = fopen(path, "rb");
    base_csv csv;
    if (stream && base_csv_open(&csv, stream, path)) {
        const char **columns = calloc(csv.columns + 1, sizeof *columns);
        for (size_t c = 0; columns && c < csv.columns; c++)
            columns[c] = csv.header[c];
        if (columns) {
            html_table_begin(report->page, caption, columns);
            while (base_csv_next(&csv) > 0)
                cells(report, &csv);
            html_table_end(report->page, NULL);
        }
        free(columns);
        base_csv_close(&csv);
    }
    if (stream)
        fclose(stream);
    free(path);
}
