/* What a frame integrates, as a file that sgfit choose and sgfit fit read. */
#include "output.h"

#include <math.h>
#include <stdlib.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/text.h"

/* Cells of an eighth of a factor e in lambda and of 1/64 in cos_theta. */
enum { LAMBDA_STEPS = 8, LAMBDA_LEAST = -16, LAMBDA_CELLS = 320, COSINE_CELLS = 128 };

typedef struct cell {
    double weight, logarithm, cosine; /* the sums of these, weighted */
} cell;

static int between(double x, int most)
{
    return x > 0 ? x < most ? (int)x : most : 0;
}

static void add(cell *cells, const float point[3])
{
    double lambda = (double)point[0], cosine = (double)point[1], weight = (double)point[2];
    if (!(lambda > 0) || isinf(lambda) || !(weight > 0) || isinf(weight) || isnan(cosine))
        return;
    double logarithm = log(lambda);
    int row = between((logarithm - LAMBDA_LEAST) * LAMBDA_STEPS, LAMBDA_CELLS - 1);
    int column = between((cosine + 1) * COSINE_CELLS / 2, COSINE_CELLS - 1);
    cell *at = &cells[row * COSINE_CELLS + column];
    at->weight += weight;
    at->logarithm += weight * logarithm;
    at->cosine += weight * fmin(fmax(cosine, -1), 1);
}

bool output_profile(const char *path, const float *points, size_t count)
{
    enum { CELLS = LAMBDA_CELLS * COSINE_CELLS };
    cell *cells = base_allocate(CELLS * sizeof *cells);
    for (int i = 0; i < CELLS; i++)
        cells[i] = (cell){0, 0, 0};
    for (size_t i = 0; i < count; i++)
        add(cells, points + 3 * i);
    double all = 0;
    for (int i = 0; i < CELLS; i++)
        all += cells[i].weight;
    buffer text = {NULL, 0, 0};
    buffer_add(&text, "lambda,cos_theta,weight\n");
    for (int i = 0; i < CELLS; i++) {
        if (!(cells[i].weight > 0))
            continue;
        char lambda[BASE_NUMBER_SIZE], cosine[BASE_NUMBER_SIZE], weight[BASE_NUMBER_SIZE];
        base_shortest_f32((float)exp(cells[i].logarithm / cells[i].weight), lambda);
        base_shortest_f32((float)(cells[i].cosine / cells[i].weight), cosine);
        base_shortest_f32((float)(cells[i].weight / all), weight); /* shares of 1 */
        buffer_print(&text, "%s,%s,%s\n", lambda, cosine, weight);
    }
    bool good = base_write_file(path, text.text, text.length);
    buffer_free(&text);
    free(cells);
    return good;
}
