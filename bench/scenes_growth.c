/* scenes_growth.c: how lighting grows with triangles and with lights. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "scenes.h"

static const char *const pipelines[] = {"hull",         "hull_lobe",    "upsample4",
                                        "upsample_sh8", "upsample_far", NULL};
static const double pi = 3.14159265358979323846;

/* A height field of side*side squares in the plane y = 0, 8 m wide: the same hills at any side. */
static void make_hills(render_scene *scene, size_t side)
{
    size_t row = side + 1;
    scene->vertex_count = row * row;
    scene->triangle_count = 2 * side * side;
    scene->material_count = 1;
    scene->positions = base_allocate(3 * scene->vertex_count * sizeof(float));
    scene->normals = base_allocate(3 * scene->vertex_count * sizeof(float));
    scene->indices = base_allocate(3 * scene->triangle_count * sizeof(uint32_t));
    scene->materials = base_allocate(scene->triangle_count * sizeof(uint32_t));
    scene->albedos = base_allocate(3 * sizeof(float));
    scene->name = base_copy("hills", 5);
    for (int c = 0; c < 3; c++)
        scene->albedos[c] = 0.6f;
    for (size_t i = 0; i < scene->vertex_count; i++) {
        double x = 8.0 * (double)(i % row) / (double)side - 4.0,
               z = 8.0 * (double)(i / row) / (double)side - 4.0, k = 2.0 * pi / 3.0;
        double slope_x = 0.35 * k * cos(k * x) * cos(k * z),
               slope_z = -0.35 * k * sin(k * x) * sin(k * z),
               length = sqrt(slope_x * slope_x + 1.0 + slope_z * slope_z);
        float *p = scene->positions + 3 * i, *n = scene->normals + 3 * i;
        p[0] = (float)x;
        p[1] = (float)(0.35 * sin(k * x) * cos(k * z));
        p[2] = (float)z;
        n[0] = (float)(-slope_x / length);
        n[1] = (float)(1.0 / length);
        n[2] = (float)(-slope_z / length);
    }
    for (size_t i = 0; i < side * side; i++) {
        uint32_t a = (uint32_t)(i / side * row + i % side), b = a + 1, c = a + (uint32_t)row;
        const uint32_t two[6] = {a, c, b, b, c, c + 1};
        memcpy(scene->indices + 6 * i, two, sizeof two);
        scene->materials[2 * i] = scene->materials[2 * i + 1] = 0;
    }
    for (int c = 0; c < 3; c++) {
        scene->low[c] = c == 1 ? -0.35 : -4.0;
        scene->high[c] = c == 1 ? 0.35 : 4.0;
    }
    scene->camera = (render_camera){{0, 3.2, 5.2}, {0, 0, 0}, {0, 1, 0}, 50, 0.1, 100};
    scene->has_spot = true;
    scene->spot = (render_spot){{2, 4, 2}, {0, 0, 0}, 60, {40, 40, 40}};
    scene->rsm_size = 16;
}

typedef struct growth {
    const char *kind; /* what grows */
    double amount;
    size_t first, count; /* rows of the table */
} growth;

typedef struct series {
    scenes_table table;
    growth steps[16];
    size_t count;
} series;

static bool measure(const scenes_plan *plan, const render_scene *scene, const char *kind,
                    double amount, series *to)
{
    size_t before = to->table.count;
    scenes_view view = {.device = plan->device,
                        .scene = scene,
                        .name = scene->name,
                        .width = plan->quick ? 480 : 1280,
                        .height = plan->quick ? 270 : 720,
                        .runs = plan->quick ? 2 : 3,
                        .enough_ms = 2000.0,
                        .warm = plan->warm};
    if (!scenes_measure(&view, pipelines, NULL, NULL, &to->table))
        return false;
    to->steps[to->count++] = (growth){kind, amount, before, to->table.count - before};
    return true;
}

static bool triangles(const scenes_plan *plan, series *to)
{
    static const size_t sides[] = {22, 71, 224, 707};
    bool good = true;
    for (size_t i = 0; i < sizeof sides / sizeof *sides && good; i++) {
        render_scene scene = {0};
        make_hills(&scene, sides[i]);
        good = measure(plan, &scene, "triangles", (double)scene.triangle_count, to);
        render_scene_free(&scene);
    }
    return good;
}

static bool lights(const scenes_plan *plan, series *to)
{
    static const int sizes[] = {4, 8, 16, 32, 64};
    render_scene scene;
    char *path = render_scene_default();
    bool good = render_scene_read(path, plan->folder, &scene);
    free(path);
    if (!good)
        return false;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes - (plan->quick ? 1 : 0) && good; i++) {
        scene.rsm_size = sizes[i];
        good = measure(plan, &scene, "lights", (double)(sizes[i] * sizes[i]), to);
    }
    render_scene_free(&scene);
    return good;
}

static bool write(const series *all, const char *path)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fputs("what,amount,pipeline,lighting_ms,evaluations,rel,p99\n", output.stream);
    for (size_t s = 0; s < all->count; s++)
        for (size_t i = 0; i < all->steps[s].count; i++) {
            const scenes_row *row = &all->table.rows[all->steps[s].first + i];
            const double numbers[] = {row->lighting_ms, (double)row->statistics.light_evaluations,
                                      row->error.rel, row->error.p99};
            char text[BASE_NUMBER_SIZE];
            fprintf(output.stream, "%s,%s,%s", all->steps[s].kind,
                    base_shortest_f64(all->steps[s].amount, text), row->pipeline);
            for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++)
                fprintf(output.stream, ",%s", base_shortest_f64(numbers[n], text));
            fputc('\n', output.stream);
        }
    return base_output_close(&output);
}

bool scenes_growth(const scenes_plan *plan)
{
    series all = {0};
    char *csv = base_join(plan->out, "growth.csv");
    bool good = triangles(plan, &all) && lights(plan, &all) && write(&all, csv);
    free(csv);
    scenes_table_free(&all.table);
    return good;
}
