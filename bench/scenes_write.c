/* scenes_write.c: rows and pass times as CSV. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/file.h"
#include "base/text.h"
#include "scenes.h"

static void write_key(FILE *out, const scenes_row *row)
{
    fprintf(out, "%s,%" PRIu32 ",%" PRIu32 ",%s,%s,%s", row->scene, row->width, row->height,
            row->detailed ? "detailed" : "smooth", row->pipeline, row->method);
}

static void write_number(FILE *out, double value)
{
    char text[BASE_NUMBER_SIZE];
    fprintf(out, ",%s", base_shortest_f64(value, text));
}

static void write_row(FILE *out, const scenes_row *row)
{
    const render_statistics *s = &row->statistics;
    const render_comparison *e = &row->error;
    write_key(out, row);
    const double errors[] = {e->rel, e->p50, e->p95, e->p99, e->p999, e->bias, row->jump_p99};
    for (size_t i = 0; i < sizeof errors / sizeof *errors; i++)
        write_number(out, errors[i]);
    const uint64_t counts[] = {
        s->pixels_covered,    s->pixels_uncovered,         s->pixels_wrong, s->quads, s->vertices,
        s->light_evaluations, s->ground_truth_evaluations, s->triangles,    s->lights};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        fprintf(out, ",%" PRIu64, counts[i]);
    double pairs = (double)s->ground_truth_evaluations;
    write_number(out, pairs > 0.0 ? 100.0 * (double)s->light_evaluations / pairs : 0.0);
    write_number(out, row->lighting_ms);
    write_number(out, row->lighting_ms > 0.0 ? row->truth_ms / row->lighting_ms : 0.0);
    fputc('\n', out);
}

bool scenes_write_csv(const scenes_table *table, const char *path)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fputs("scene,width,height,normals,pipeline,method,rel,p50,p95,p99,p999,bias,jump_p99,"
          "pixels_covered,pixels_uncovered,pixels_wrong,quads,vertices,light_evaluations,"
          "ground_truth_evaluations,triangles,lights,evaluations_percent,lighting_ms,"
          "times_faster_than_exact\n",
          output.stream);
    for (size_t i = 0; i < table->count; i++)
        write_row(output.stream, &table->rows[i]);
    return base_output_close(&output);
}

bool scenes_write_passes(const scenes_table *table, const char *path)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fputs("scene,width,height,normals,pipeline,method,pass,ms\n", output.stream);
    for (size_t i = 0; i < table->count; i++) {
        const scenes_row *row = &table->rows[i];
        for (int t = 0; t < row->statistics.time_count; t++) {
            write_key(output.stream, row);
            fprintf(output.stream, ",%s", row->statistics.times[t].name);
            write_number(output.stream, row->statistics.times[t].ms);
            fputc('\n', output.stream);
        }
    }
    return base_output_close(&output);
}
