#include "meder_reference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sg.h"

/* ---- Segmentation -----------------------------------------------------------------------------
 */

enum { N = MEDER_SIDE, T = MEDER_TILE };

/* The paper's pseudocode on one line of a tile. */
static void propagate(reference *r, int x, int y, int dx, int dy, float threshold)
{
    float current = r->depth[y * N + x];
    uint32_t carried = r->labels[y * N + x];
    for (int i = 0; i < T; i++, x += dx, y += dy) {
        float next = r->depth[y * N + x];
        if (fabsf(current - next) > threshold * (1 - current))
            carried = r->labels[y * N + x];
        else
            r->labels[y * N + x] = carried;
        current = next;
    }
}

static void segment_tile(reference *r, int left, int top, float threshold)
{
    for (int y = 0; y < T; y++)
        for (int x = 0; x < T; x++)
            r->labels[(top + y) * N + left + x] = (uint32_t)(y * T + x);
    for (int y = 0; y < T; y++)
        propagate(r, left, top + y, 1, 0, threshold);
    for (int x = 0; x < T; x++)
        propagate(r, left + x, top, 0, 1, threshold);
    for (int y = 0; y < T; y++)
        propagate(r, left + T - 1, top + y, -1, 0, threshold);
    for (int x = 0; x < T; x++)
        propagate(r, left + x, top + T - 1, 0, -1, threshold);
}

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static uint32_t most(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

static void box_tile(reference *r, int left, int top)
{
    uint32_t tile = (uint32_t)(top / T * MEDER_TILES + left / T);
    meder_box boxes[T * T];
    bool used[T * T] = {false};
    for (int y = top; y < top + T; y++)
        for (int x = left; x < left + T; x++) {
            float z = r->depth[y * N + x];
            uint32_t label = r->labels[y * N + x], at[2] = {(uint32_t)x, (uint32_t)y};
            if (!(z < 1))
                continue;
            meder_box *box = &boxes[label];
            if (!used[label])
                *box = (meder_box){{at[0], at[1]}, {at[0], at[1]}, z, z, tile * 1024 + label, 0};
            used[label] = true;
            for (int k = 0; k < 2; k++) {
                box->low[k] = least(box->low[k], at[k]);
                box->high[k] = most(box->high[k], at[k]);
            }
            box->z_low = fminf(box->z_low, z);
            box->z_high = fmaxf(box->z_high, z);
        }
    for (int i = 0; i < T * T; i++)
        if (used[i])
            r->boxes[r->count++] = boxes[i];
}

void reference_segment(reference *r, const float *depth, uint32_t width, uint32_t height,
                       float threshold)
{
    r->count = 0;
    r->boxes = calloc(MEDER_MOST_SEGMENTS, sizeof *r->boxes);
    for (uint32_t y = 0; y < N; y++)
        for (uint32_t x = 0; x < N; x++) {
            /* the pixel that holds the texel's centre */
            uint32_t px = (uint32_t)floor((x + 0.5) * width / N);
            uint32_t py = (uint32_t)floor((y + 0.5) * height / N);
            r->depth[y * N + x] = depth[(size_t)py * width + px];
        }
    for (int top = 0; top < N; top += T)
        for (int left = 0; left < N; left += T) {
            segment_tile(r, left, top, threshold);
            box_tile(r, left, top);
        }
}

void reference_free(reference *r)
{
    free(r->boxes);
    r->boxes = NULL;
}

/* ---- Corners ----------------------------------------------------------------------------------
 */

static void unproject(const view_data *view, const double at[2], double depth, double out[4])
{
    const double clip[4] = {at[0], at[1], depth, 1};
    for (int row = 0; row < 4; row++) {
        out[row] = 0;
        for (int k = 0; k < 4; k++)
            out[row] += (double)view->world_from_clip[4 * k + row] * clip[k];
    }
    for (int k = 0; k < 3; k++)
        out[k] /= out[3];
}

void reference_unproject(const view_data *view, const double at[2], double depth, float out[4])
{
    double p[4], ahead = 0;
    unproject(view, at, depth, p);
    for (int k = 0; k < 3; k++) {
        out[k] = (float)p[k];
        ahead += (p[k] - (double)view->eye[k]) * (double)view->forward[k];
    }
    out[3] = (float)ahead;
}

void reference_middle(const view_data *view, const meder_box *box, uint32_t corner,
                      double position[3])
{
    const double at[2] = {2.0 * (corner & 1 ? box->high[0] + 1 : box->low[0]) / N - 1,
                          2.0 * (corner & 2 ? box->high[1] + 1 : box->low[1]) / N - 1};
    double p[4];
    unproject(view, at, 0.5 * ((double)box->z_low + (double)box->z_high), p);
    memcpy(position, p, 3 * sizeof *position);
}

/* ---- Light --------------------------------------------------------------------------------------
 */

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void reference_lights(light_data *lights, int count)
{
    for (int i = 0; i < count; i++) {
        light_data *l = &lights[i];
        double turn = 2.4 * i, place[3] = {1.5 * cos(turn), 2 + 0.3 * i, 1.5 * sin(turn) - 2};
        double side[3] = {0.2, 0.1 * i, 0.1}, other[3] = {-0.1, 0.05, 0.3}, normal[3];
        cross(side, other, normal);
        double size = sqrt(dot(normal, normal));
        for (int k = 0; k < 3; k++) {
            l->a[k] = (float)place[k];
            l->b[k] = (float)(place[k] + side[k]);
            l->c[k] = (float)(place[k] + other[k]);
            l->plane[k] = (float)(normal[k] / size);
        }
        l->plane[3] = (float)(0.5 * size);
        l->a[3] = (float)(1 + i);
        l->b[3] = i % 2 ? 0 : 2;
        l->c[3] = 0.5F;
    }
}

/* Solid angle of a triangle by its three corners' angles: their sum less pi (Girard). */
static double solid_angle(double v[3][3])
{
    double normals[3][3], sum = -3.14159265358979323846;
    for (int i = 0; i < 3; i++)
        cross(v[i], v[(i + 1) % 3], normals[i]);
    for (int i = 0; i < 3; i++) {
        const double *a = normals[(i + 2) % 3], *b = normals[i];
        double across[3];
        cross(a, b, across);
        sum += atan2(sqrt(dot(across, across)), -dot(a, b));
    }
    return sum;
}

static void gather(const light_data *lights, int count, const double x[3], double flux[3],
                   double moment[3][3])
{
    memset(flux, 0, 3 * sizeof *flux);
    memset(moment, 0, 9 * sizeof(double));
    for (int i = 0; i < count; i++) {
        const light_data *l = &lights[i];
        const float *corners[3] = {l->a, l->b, l->c};
        double v[3][3], in_front = 0;
        for (int k = 0; k < 3; k++)
            in_front -= ((double)l->a[k] - x[k]) * (double)l->plane[k];
        for (int j = 0; j < 3; j++) {
            for (int k = 0; k < 3; k++)
                v[j][k] = (double)corners[j][k] - x[k];
            double length = sqrt(dot(v[j], v[j]));
            for (int k = 0; k < 3; k++)
                v[j][k] /= length;
        }
        double angle = in_front < 0.002 ? 0 : solid_angle(v);
        for (int c = 0; c < 3; c++) {
            double mu = (double)corners[c][3] / 3.14159265358979323846 * angle;
            flux[c] += mu;
            for (int j = 0; j < 3; j++)
                for (int k = 0; k < 3; k++)
                    moment[c][k] += mu * v[j][k] / 3;
        }
    }
}

double reference_lobe_difference(const light_data *lights, int count, const meder_record *record)
{
    double x[3], flux[3], moment[3][3], worst = 0;
    for (int k = 0; k < 3; k++)
        x[k] = (double)record->after[k];
    gather(lights, count, x, flux, moment);
    for (int c = 0; c < 3; c++) {
        double size = sqrt(dot(moment[c], moment[c])), lambda = (double)record->lobes[c][3];
        if (flux[c] == 0) {
            worst = fmax(worst, fabs((double)record->amplitude[c]));
            continue;
        }
        double got = (double)record->amplitude[c] * sg_A(lambda);
        worst = fmax(worst, fabs(got - flux[c]) / flux[c]);
        worst = fmax(worst, fabs(lambda / (1 + lambda) - size / flux[c]));
        for (int k = 0; k < 3; k++)
            worst = fmax(worst, fabs((double)record->lobes[c][k] - moment[c][k] / size));
    }
    return worst;
}
