/* scenes_lobe_lights.c: from many small lights to two virtual spherical Gaussian ones. */
#include <math.h>
#include <string.h>

#include "scenes_lobes.h"
#include "sg.h"

/* The lobe that stands for a cosine: what the surfaces of a cluster emit about their normals. */
static const double cosine_sharpness = 2.123;

int lobe_light_sharp(const render_scene *scene, lobe_light lights[LOBE_LIGHTS])
{
    double size[3], centre[3];
    for (int c = 0; c < 3; c++) {
        size[c] = scene->high[c] - scene->low[c];
        centre[c] = 0.5 * (scene->high[c] + scene->low[c]);
    }
    double scale = fmax(size[0], fmax(size[1], size[2]));
    lobe_light *l = &lights[0];
    /* in front of the wall behind what the camera looks at, a twentieth of the scene away */
    for (int c = 0; c < 3; c++)
        l->centre[c] = (float)centre[c];
    l->centre[2] = (float)(scene->low[2] + 0.05 * scale);
    l->variance = (float)(1e-5 * scale * scale);
    memset(l->axis, 0, sizeof l->axis);
    l->sharpness = 0.0f;
    for (int c = 0; c < 4; c++)
        l->intensity[c] = 1.0f;
    return 1;
}

/* A light of the frame: where, its normal, its flux. */
typedef struct small_light {
    double at[3], normal[3], flux[3], power;
} small_light;

static small_light read_light(const float *words)
{
    small_light s;
    for (int c = 0; c < 3; c++) {
        s.at[c] = ((double)words[c] + (double)words[4 + c] + (double)words[8 + c]) / 3.0;
        s.normal[c] = (double)words[12 + c];
        s.flux[c] = (double)words[4 * c + 3] * (double)words[15];
    }
    s.power = s.flux[0] + s.flux[1] + s.flux[2];
    return s;
}

static double squared_distance(const double a[3], const double b[3])
{
    double sum = 0.0;
    for (int c = 0; c < 3; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

static void start_centres(const float *words, uint32_t count, double centres[LOBE_LIGHTS][3])
{
    double strongest = -1.0, farthest = -1.0;
    for (uint32_t i = 0; i < count; i++) {
        small_light s = read_light(words + 16 * i);
        if (s.power > strongest) {
            strongest = s.power;
            memcpy(centres[0], s.at, sizeof s.at);
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        small_light s = read_light(words + 16 * i);
        double d = squared_distance(s.at, centres[0]);
        if (d > farthest) {
            farthest = d;
            memcpy(centres[1], s.at, sizeof s.at);
        }
    }
}

/* Sums over the lights nearest to each centre. */
typedef struct cluster {
    double at[3], normal[3], flux[3], power, spread;
} cluster;

static void gather(const float *words, uint32_t count, double centres[LOBE_LIGHTS][3],
                   cluster clusters[LOBE_LIGHTS])
{
    memset(clusters, 0, LOBE_LIGHTS * sizeof *clusters);
    for (uint32_t i = 0; i < count; i++) {
        small_light s = read_light(words + 16 * i);
        double d0 = squared_distance(s.at, centres[0]), d1 = squared_distance(s.at, centres[1]);
        cluster *k = &clusters[d1 < d0];
        for (int c = 0; c < 3; c++) {
            k->at[c] += s.power * s.at[c];
            k->normal[c] += s.power * s.normal[c];
            k->flux[c] += s.flux[c];
        }
        k->power += s.power;
        k->spread += s.power * fmin(d0, d1);
    }
}

static void make_lobe(const cluster *k, const double centre[3], lobe_light *out)
{
    double length = sqrt(squared_distance(k->normal, (const double[3]){0, 0, 0}));
    double mean = fmin(length / k->power, 0.999999);
    /* Banerjee's sharpness of the normals, and a cosine about each of them */
    double normals = mean * (3.0 - mean * mean) / (1.0 - mean * mean);
    double sharpness = normals * cosine_sharpness / (normals + cosine_sharpness);
    for (int c = 0; c < 3; c++) {
        out->centre[c] = (float)centre[c];
        out->axis[c] = length > 0.0 ? (float)(k->normal[c] / length) : 0.0f;
        out->intensity[c] = (float)(k->flux[c] / sg_A(sharpness));
    }
    out->intensity[3] = 0.0f;
    out->sharpness = (float)sharpness;
    /* surfaces are flat: the spread is that of two axes */
    out->variance = (float)fmax(0.5 * k->spread / k->power, 1e-8);
}

int lobe_lights_of(render_frame *frame, lobe_light lights[LOBE_LIGHTS])
{
    const float *words = gpu_buffer_map(frame->lights);
    double centres[LOBE_LIGHTS][3] = {{0}};
    cluster clusters[LOBE_LIGHTS];
    start_centres(words, frame->light_count, centres);
    for (int round = 0; round < 20; round++) {
        gather(words, frame->light_count, centres, clusters);
        for (int k = 0; k < LOBE_LIGHTS; k++)
            for (int c = 0; c < 3 && clusters[k].power > 0.0; c++)
                centres[k][c] = clusters[k].at[c] / clusters[k].power;
    }
    gather(words, frame->light_count, centres, clusters);
    int count = 0;
    for (int k = 0; k < LOBE_LIGHTS; k++)
        if (clusters[k].power > 0.0)
            make_lobe(&clusters[k], centres[k], &lights[count++]);
    if (count == 0) { /* a dark scene */
        lights[0] = (lobe_light){.variance = 1.0f};
        count = 1;
    }
    return count;
}
