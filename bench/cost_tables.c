/* cost_tables.c: look-up tables, which count too: with their arithmetic and their fetches. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"
#include "cost.h"
#include "tables/curves.h"
#include "tables/emit.h"
#include "tables/tail.h"

enum { LINE = 128 };

/* One table: its text, and what makes its texels. */
typedef struct table {
    const char *id, *path, *sampler;
    uint32_t width, height, channels;
    bool (*fill)(float *texels);
} table;

static bool fill_tail(float *texels)
{
    double *exact = base_allocate(TAIL_SIZE * TAIL_SIZE * sizeof *exact);
    tail_fit(exact);
    for (size_t i = 0; i < (size_t)TAIL_SIZE * TAIL_SIZE; i++)
        texels[i] = (float)exact[i];
    free(exact);
    return true;
}

/* The sharpness at place u = lambda/(lambda + 2) in [0, 1]. */
static double sharpness_at(double u)
{
    return u < 1 ? 2 * u / (1 - u) : (double)INFINITY;
}

/* m where u lies between texels i and i + 1, less the line between their exact values: half of it,
 * at the middle, is what each end is moved by, so that the error has both signs. */
static double bulge(int i)
{
    const double last = TAIL_SIZE - 1;
    if (i < 0 || i >= TAIL_SIZE - 1)
        return 0;
    double left = sg_mean_from_sharpness(sharpness_at(i / last));
    double right = sg_mean_from_sharpness(sharpness_at((i + 1) / last));
    return sg_mean_from_sharpness(sharpness_at((i + 0.5) / last)) - 0.5 * (left + right);
}

static bool fill_pair(float *texels)
{
    float *tail = base_allocate(TAIL_SIZE * TAIL_SIZE * sizeof *tail);
    fill_tail(tail);
    for (int i = 0; i < TAIL_SIZE; i++) {
        double m = sg_mean_from_sharpness(sharpness_at(i / (double)(TAIL_SIZE - 1)));
        m += 0.25 * (bulge(i - 1) + bulge(i));
        for (int j = 0; j < TAIL_SIZE; j++) {
            texels[2 * (j * TAIL_SIZE + i)] = tail[j * TAIL_SIZE + i];
            texels[2 * (j * TAIL_SIZE + i) + 1] = (float)m;
        }
    }
    free(tail);
    return true;
}

static bool fill_line(float *texels)
{
    double t = 0, u = 2;
    for (int i = 0; i < LINE; i++, texels += 4) {
        double lambda = sharpness_at(i / (LINE - 1.0)), root = sqrt(lambda + 2);
        if (i == 0) {
            texels[0] = 0;
            texels[1] = (float)(2 * root);
            texels[2] = (float)(0.25 * root);
            texels[3] = 0;
        } else if (i == LINE - 1) {
            texels[0] = 2.1583F; /* the planar limits */
            texels[1] = 1.5690F;
            texels[2] = 0;
            texels[3] = 1;
        } else {
            if (i == 1)
                t = 0.375 * lambda;
            if (!curves_logistic(lambda, &t, &u)) {
                base_error("no steepness found at sharpness %g", lambda);
                return false;
            }
            texels[0] = (float)(t / root);
            texels[1] = (float)(u * root);
            texels[2] = (float)(sg_L_cos(lambda, -1) * root);
            texels[3] = (float)sg_mean_from_sharpness(lambda);
        }
    }
    return true;
}

static const table tables[] = {
    {"table_2d", "shaders/forms/table.glsl", "sampler2D", TAIL_SIZE, TAIL_SIZE, 1, fill_tail},
    {"table_2d_pair", "bench/lookup/pair.glsl", "sampler2D", TAIL_SIZE, TAIL_SIZE, 2, fill_pair},
    {"table_1d", "bench/lookup/line.glsl", "sampler1D", LINE, 0, 4, fill_line},
};

size_t cost_table_count(void)
{
    return sizeof tables / sizeof *tables;
}

const char *cost_table_id(size_t index)
{
    return tables[index].id;
}

bool cost_table_subject(size_t index, const form_list *forms, sg_quantity quantity,
                        cost_subject *subject)
{
    const table *table = &tables[index];
    char *path = base_join(base_source_root(), table->path);
    char *source = base_read_file(path, NULL);
    buffer text = {0};
    /* A_h asks for one helper more, which the emitter then brings along. */
    buffer wanted = {0};
    if (source) {
        buffer_add(&wanted, source);
        buffer_print(&wanted,
                     "layout(set = 0, binding = 2) uniform %s lookup;\n"
                     "float f(float lambda, float cos_theta)\n{\n"
                     "    return sg_L_table(lookup, lambda, cos_theta)%s;\n}\n",
                     table->sampler, quantity == SG_L ? "" : " * sg_integral(lambda)");
    }
    bool good = source && emit_table_glsl(&text, forms, path, wanted.text);
    free(source);
    free(path);
    buffer_free(&wanted);
    uint32_t rows = table->height ? table->height : 1;
    float *texels = base_allocate((size_t)table->width * rows * table->channels * sizeof *texels);
    good = good && table->fill(texels);
    if (!good) {
        buffer_free(&text);
        free(texels);
        return false;
    }
    *subject = (cost_subject){
        .id = base_copy(table->id, strlen(table->id)),
        .quantity = quantity,
        .glsl = text.text,
        .texture = {table->width, table->height, (int)table->channels, false, texels},
        .fetches = 1};
    return true;
}
