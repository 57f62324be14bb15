/* lpv_fixture.h: a volume on the device that a test fills and reads, and the passes of shaders/lpv
 * over it. */
#ifndef LPV_FIXTURE_H
#define LPV_FIXTURE_H

#include "pass_fixture.h"

#include <math.h>

#include "render/internal.h"
#include "render/lpv.h"

/* struct Lobes and struct Passed of shaders/lpv/volume.glsl. */
typedef struct lobes_data {
    float of[3][4];
} lobes_data;
typedef struct passed_data {
    float by[6][4];
} passed_data;

typedef struct grid {
    gpu_device *device;
    render_frame frame; /* only its device is used */
    lpv_push push;
    gpu_buffer *samples, *reflected, *first, *entries, *open, *lobes[2], *sums;
    gpu_compute *deposit, *propagate;
    int step;
} grid;

static inline gpu_buffer *upload(gpu_device *device, const void *data, size_t size)
{
    gpu_buffer *buffer = make_buffer(device, size);
    memcpy(gpu_buffer_map(buffer), data, size);
    return buffer;
}

/* Every face open; 8 samples and as many sides as entries may name. */
static inline void grid_open(grid *g, uint32_t x, uint32_t y, uint32_t z, float side)
{
    static const gpu_binding buffers[6] = {GPU_STORAGE_BUFFER};
    *g = (grid){.device = open_software_device()};
    g->frame.device = g->device;
    g->push = (lpv_push){
        .size = {x, y, z}, .voxels = x * y * z, .side = side, .sharpest = lpv_default.sharpest};
    size_t voxels = g->push.voxels;
    g->samples = make_buffer(g->device, 8 * sizeof(lpv_sample));
    g->reflected = make_buffer(g->device, 16 * 16);
    g->first = make_buffer(g->device, 4 * (voxels + 1));
    g->entries = make_buffer(g->device, 64 * sizeof(struct lpv_entry));
    g->open = make_buffer(g->device, 16 * voxels);
    g->sums = make_buffer(g->device, sizeof(passed_data) * voxels);
    memset(gpu_buffer_map(g->first), 0, 4 * (voxels + 1));
    for (int i = 0; i < 2; i++)
        g->lobes[i] = make_buffer(g->device, sizeof(lobes_data) * voxels);
    float *open = gpu_buffer_map(g->open);
    for (size_t i = 0; i < 4 * voxels; i++)
        open[i] = 1;
    must(render_compute(&g->frame, "lpv/deposit.comp", false, buffers, 6, sizeof(lpv_push),
                        &g->deposit));
    must(render_compute(&g->frame, "lpv/propagate.comp", false, buffers, 4, sizeof(lpv_push),
                        &g->propagate));
}

static inline void grid_close(grid *g)
{
    gpu_buffer *const all[] = {g->samples, g->reflected, g->first,    g->entries,
                               g->open,    g->sums,      g->lobes[0], g->lobes[1]};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        gpu_buffer_destroy(all[i]);
    gpu_compute_destroy(g->deposit);
    gpu_compute_destroy(g->propagate);
    close_clean(g->device);
}

static inline uint32_t grid_voxel(const grid *g, uint32_t x, uint32_t y, uint32_t z)
{
    return x + g->push.size[0] * (y + g->push.size[1] * z);
}

static inline void grid_deposit(grid *g)
{
    gpu_step step = {
        .name = "deposit",
        .compute = g->deposit,
        .push = &g->push,
        .resources = {g->samples, g->reflected, g->first, g->entries, g->lobes[0], g->sums},
        .groups = {(g->push.voxels + 63) / 64, 1, 1}};
    must(gpu_run(g->device, &step, 1, NULL));
    g->step = 0;
}

static inline void grid_propagate(grid *g, int steps)
{
    for (int i = 0; i < steps; i++, g->step++) {
        gpu_step step = {
            .name = "propagate",
            .compute = g->propagate,
            .push = &g->push,
            .resources = {g->lobes[g->step % 2], g->lobes[1 - g->step % 2], g->open, g->sums},
            .groups = {(g->push.voxels + 63) / 64, 1, 1}};
        must(gpu_run(g->device, &step, 1, NULL));
    }
}

/* The light of this step. */
static inline const lobes_data *grid_lobes(const grid *g)
{
    return gpu_buffer_map(g->lobes[g->step % 2]);
}

static inline passed_data *grid_sums(const grid *g)
{
    return gpu_buffer_map(g->sums);
}

/* ---- The same on the host -------------------------------------------------------------- */

/* Of the light that leaves a voxel: 30 parts of all directions, 6 along the axes (the number is
 * that of the axis times 2, plus 1 where it is the negative one) and 24 between two axes. */
typedef struct host_part {
    int to, beside;             /* the nearer axis, as above, and the other or -1 */
    double angle, towards[3];   /* solid angle, direction that the lobe is taken in */
    double mean[3];             /* mean direction */
    double share, share_beside; /* of what leaves towards the two */
} host_part;

static inline void host_add(double v[3], int axis, double length)
{
    v[axis / 2] += axis % 2 ? -length : length;
}

static inline host_part host_part_of(int i)
{
    host_part p = {.to = i / 5, .beside = -1, .angle = 4 * asin(0.1)};
    if (i % 5 == 0) {
        host_add(p.towards, p.to, 1);
        host_add(p.mean, p.to, 0.967);
        p.share = 0.763;
    } else {
        p.beside = (p.to / 2 * 2 + 1 + i % 5) % 6; /* the four that are not of the same axis */
        p.angle = (4 * 3.14159265358979323846 / 6 - p.angle) / 4;
        host_add(p.towards, p.to, 0.839);
        host_add(p.towards, p.beside, 0.544);
        host_add(p.mean, p.to, 0.799);
        host_add(p.mean, p.beside, 0.518);
        p.share = 0.61;
        p.share_beside = 0.39;
    }
    return p;
}

/* Flux of a lobe in that part. */
static inline double host_flux(const float lobe[4], const host_part *p)
{
    double x = 0;
    for (int k = 0; k < 3; k++)
        x += (double)lobe[k] * p->towards[k];
    return (double)lobe[3] * p->angle / pow(1 - x, 4);
}

/* The share of a part that leaves through the face towards an axis; the straight ones lose a part
 * to the four beside them. */
static inline double host_share(const host_part *p, int axis)
{
    if (axis == p->to)
        return p->share;
    if (p->beside < 0)
        return axis / 2 == p->to / 2 ? 0 : (1 - p->share) / 4;
    return axis == p->beside ? p->share_beside : 0;
}

/* All that a lobe sends out, W. */
static inline double host_sum(const float lobe[4])
{
    double sum = 0;
    for (int i = 0; i < 30; i++) {
        host_part p = host_part_of(i);
        sum += host_flux(lobe, &p);
    }
    return sum;
}

/* What a voxel that holds a flux with a mean direction sends on, as struct Lobes has it. */
static inline void host_lobe(const grid *g, const double along[3], double flux, float lobe[4])
{
    double m[3] = {0, 0, 0}, size = 0;
    for (int k = 0; k < 3 && flux > 0; k++) {
        m[k] = along[k] / flux;
        size += m[k] * m[k];
    }
    size = sqrt(size);
    double cut = size > (double)g->push.sharpest ? (double)g->push.sharpest / size : 1;
    double b = 3 * cut / (2 + sqrt(4 - 3 * cut * cut * size * size));
    for (int k = 0; k < 3; k++)
        lobe[k] = (float)(b * m[k]);
    lobe[3] = 1;
    lobe[3] = flux > 0 ? (float)(flux / host_sum(lobe)) : 0;
}

/* That of all voxels. */
static inline double host_energy(const grid *g, int colour)
{
    double sum = 0;
    for (uint32_t v = 0; v < g->push.voxels; v++)
        sum += host_sum(grid_lobes(g)[v].of[colour]);
    return sum;
}

#endif
