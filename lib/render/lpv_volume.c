/* Where the volume lies, what is deposited in which voxel, and what blocks light between two. */
#include "lpv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"

static void place_volume(const render_scene *scene, uint32_t volume, lpv_volume *v)
{
    double extent[3], longest = 0;
    for (int k = 0; k < 3; k++) {
        extent[k] = scene->high[k] - scene->low[k];
        longest = fmax(longest, extent[k]);
    }
    v->side = longest > 0 ? longest / volume : 1;
    v->voxels = 1;
    for (int k = 0; k < 3; k++) {
        double count = ceil(extent[k] / v->side - 1e-4);
        /* a flat scene has a voxel on either side of it */
        double least = volume > 1 && extent[k] < 0.01 * v->side ? 2 : 1;
        v->size[k] = (uint32_t)fmin(fmax(count, least), volume > 1 ? volume : 1);
        v->low[k] = 0.5 * (scene->low[k] + scene->high[k] - v->side * v->size[k]);
        v->voxels *= v->size[k];
    }
}

static int64_t voxel_of(const lpv_volume *v, const double p[3])
{
    int64_t cell[3];
    for (int k = 0; k < 3; k++) {
        double x = floor((p[k] - v->low[k]) / v->side);
        if (!(x >= 0 && x < v->size[k]))
            return -1;
        cell[k] = (int64_t)x;
    }
    return cell[0] + v->size[0] * (cell[1] + (int64_t)v->size[1] * cell[2]);
}

/* ---- What is deposited ---------------------------------------------------------------- */

typedef struct deposit {
    uint32_t voxel, side;
} deposit;

static int by_voxel(const void *a, const void *b)
{
    const deposit *x = a, *y = b;
    if (x->voxel != y->voxel)
        return x->voxel < y->voxel ? -1 : 1;
    return (x->side > y->side) - (x->side < y->side);
}

/* A list of darts by voxel, sample and side; those that share all three make one entry. */
static void list_deposits(const lpv_samples *s, lpv_volume *v)
{
    deposit *all = base_allocate((2 * s->dart_count + 1) * sizeof *all);
    size_t count = 0;
    for (size_t i = 0; i < s->dart_count; i++)
        for (uint32_t side = 0; side < 2; side++) {
            const lpv_dart *dart = &s->darts[i];
            const float *face = s->samples[dart->sample].face;
            float along = 0;
            for (int k = 0; k < 3; k++)
                along += face[k] * dart->face[k];
            double p[3], away = (side ? -0.5 : 0.5) * v->side * (along < 0 ? -1 : 1);
            for (int k = 0; k < 3; k++)
                p[k] = (double)dart->position[k] + away * (double)dart->face[k];
            int64_t voxel = voxel_of(v, p);
            if (voxel >= 0)
                all[count++] = (deposit){(uint32_t)voxel, 2 * dart->sample + side};
        }
    qsort(all, count, sizeof *all, by_voxel);
    v->first = base_allocate((v->voxels + 1) * sizeof *v->first);
    v->entries = base_allocate((count + 1) * sizeof *v->entries);
    size_t at = 0;
    for (size_t voxel = 0; voxel < v->voxels; voxel++) {
        v->first[voxel] = (uint32_t)v->entry_count;
        for (; at < count && all[at].voxel == voxel; at++) {
            bool same = v->entry_count > v->first[voxel] &&
                        v->entries[v->entry_count - 1].side == all[at].side;
            if (!same)
                v->entries[v->entry_count++] = (struct lpv_entry){all[at].side, 0};
            v->entries[v->entry_count - 1].area += (float)s->dart_area;
        }
    }
    v->first[v->voxels] = (uint32_t)v->entry_count;
    free(all);
}

/* ---- What blocks ---------------------------------------------------------------------- */

static void fill_open(const lpv_samples *s, lpv_volume *v)
{
    v->open = base_allocate(4 * v->voxels * sizeof *v->open);
    memset(v->open, 0, 4 * v->voxels * sizeof *v->open);
    double share = s->dart_area / (v->side * v->side);
    for (size_t i = 0; i < s->dart_count; i++)
        for (int k = 0; k < 3; k++) {
            double p[3];
            for (int j = 0; j < 3; j++)
                p[j] = (double)s->darts[i].position[j] - (j == k ? 0.5 * v->side : 0);
            int64_t voxel = voxel_of(v, p);
            if (voxel >= 0)
                v->open[4 * voxel + k] += (float)(share * fabs((double)s->darts[i].face[k]));
        }
    for (size_t i = 0; i < v->voxels; i++)
        for (size_t k = 0; k < 3; k++) {
            float cover = fminf(v->open[4 * i + k], 1);
            v->open[4 * i + k] = 1 - cover * cover * cover;
        }
}

void lpv_volume_make(const render_scene *scene, const lpv_samples *samples, uint32_t volume,
                     lpv_volume *result)
{
    *result = (lpv_volume){.side = 0};
    place_volume(scene, volume, result);
    list_deposits(samples, result);
    fill_open(samples, result);
}

void lpv_volume_free(lpv_volume *v)
{
    free(v->first);
    free(v->entries);
    free(v->open);
    *v = (lpv_volume){.side = 0};
}
