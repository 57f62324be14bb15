/* Structural similarity of two pictures. */
#include "render.h"

#include <math.h>
#include <stdlib.h>

#include "base/buffer.h"

enum { RADIUS = 5, MOMENTS = 5 };

/* Luminance of white surfaces under that light, tone-mapped; 0 without a surface in the truth. */
static void tone_map(size_t pixels, double gain, const float *light, const float *truth, float *to)
{
    static const float share[3] = {0.2126F, 0.7152F, 0.0722F};
    for (size_t i = 0; i < pixels; i++) {
        float luminance = 0;
        for (size_t c = 0; c < 3; c++)
            luminance += share[c] * light[4 * i + c];
        bool there = truth[4 * i + 3] != 0;
        to[i] = there ? render_tone(gain, luminance / 3.14159265F) : 0;
    }
}

/* Weighted means of a, b, a a, b b, a b over the columns, or over the rows, around each pixel;
 * what lies outside of the image counts as its edge. */
static void blur(long width, long height, bool columns, const float *from, float *to)
{
    float weights[2 * RADIUS + 1], sum = 0;
    for (int i = -RADIUS; i <= RADIUS; i++)
        sum += weights[i + RADIUS] = expf(-(float)(i * i) / (2 * 1.5F * 1.5F));
    for (long y = 0; y < height; y++)
        for (long x = 0; x < width; x++) {
            float mean[MOMENTS] = {0};
            for (long i = -RADIUS; i <= RADIUS; i++) {
                long u = columns ? x : x + i, v = columns ? y + i : y;
                u = u < 0 ? 0 : u >= width ? width - 1 : u;
                v = v < 0 ? 0 : v >= height ? height - 1 : v;
                for (long m = 0; m < MOMENTS; m++)
                    mean[m] += weights[i + RADIUS] / sum * from[MOMENTS * (v * width + u) + m];
            }
            for (long m = 0; m < MOMENTS; m++)
                to[MOMENTS * (y * width + x) + m] = mean[m];
        }
}

static double similarity(const float *mean)
{
    static const double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    double a = (double)mean[0], b = (double)mean[1];
    double aa = (double)mean[2] - a * a, bb = (double)mean[3] - b * b, ab = (double)mean[4] - a * b;
    return (2 * a * b + c1) * (2 * ab + c2) / ((a * a + b * b + c1) * (aa + bb + c2));
}

double render_ssim(uint32_t width, uint32_t height, double gain, const float *light,
                   const float *truth)
{
    size_t pixels = (size_t)width * height, count = 0;
    float *a = base_allocate((pixels + 1) * sizeof *a),
          *b = base_allocate((pixels + 1) * sizeof *b);
    float *moments = base_allocate((pixels + 1) * MOMENTS * sizeof *moments);
    float *means = base_allocate((pixels + 1) * MOMENTS * sizeof *means);
    tone_map(pixels, gain, light, truth, a);
    tone_map(pixels, gain, truth, truth, b);
    for (size_t i = 0; i < pixels; i++) {
        const float of[MOMENTS] = {a[i], b[i], a[i] * a[i], b[i] * b[i], a[i] * b[i]};
        for (size_t m = 0; m < MOMENTS; m++)
            moments[MOMENTS * i + m] = of[m];
    }
    blur((long)width, (long)height, false, moments, means);
    blur((long)width, (long)height, true, means, moments);
    double sum = 0;
    for (size_t i = 0; i < pixels; i++)
        if (truth[4 * i + 3] != 0) {
            sum += similarity(moments + MOMENTS * i);
            count++;
        }
    free(a);
    free(b);
    free(moments);
    free(means);
    return count ? sum / (double)count : 1;
}
