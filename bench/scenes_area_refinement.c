/* scenes_area_refinement.c: what thresholds of refinement cost and give: multires, as printed too,
 * and nichols, which split where more bits of visibility differ. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "render/multires.h"
#include "scenes_area.h"

static gpu_status create_multires(render_frame *frame, const void *settings, void **state)
{
    return multires_create_state(frame, settings, state);
}

static gpu_status create_nichols(render_frame *frame, const void *settings, void **state)
{
    return nichols_create_state(frame, settings, state);
}

enum { STEPS = 4, KINDS = 3 };
static const char *const kinds[KINDS] = {"multires", "multires_same", "nichols"};
static const uint32_t bits[STEPS] = {1, 2, 4, 8};

static void set_up(multires_settings settings[KINDS * STEPS],
                   scenes_variant variants[KINDS * STEPS])
{
    static const enum multires_points points[KINDS] = {MULTIRES_BOTH, MULTIRES_SAME, MULTIRES_BOTH};
    for (size_t i = 0; i < KINDS * STEPS; i++) {
        size_t kind = i / STEPS;
        bool nichols = kind == KINDS - 1;
        settings[i] = multires_default;
        settings[i].points = points[kind];
        settings[i].differing = bits[i % STEPS];
        variants[i] = (scenes_variant){.like = nichols ? &nichols_pipeline : &multires_pipeline,
                                       .create = nichols ? create_nichols : create_multires,
                                       .settings = &settings[i]};
        /* the first two columns */
        snprintf(variants[i].id, sizeof variants[i].id, "%s,%" PRIu32, kinds[kind],
                 bits[i % STEPS]);
    }
}

static bool measure(const scenes_plan *plan, const render_scene *scene, FILE *out)
{
    multires_settings settings[KINDS * STEPS];
    scenes_variant variants[KINDS * STEPS];
    set_up(settings, variants);
    const char *const none[] = {NULL};
    scenes_table table = {0};
    scenes_view view = {.device = plan->device,
                        .scene = scene,
                        .name = scene->name,
                        .width = plan->quick ? 128 : 640,
                        .height = plan->quick ? 96 : 480,
                        .truth = "shadows",
                        .variants = variants,
                        .variant_count = KINDS * STEPS};
    bool good = scenes_measure(&view, none, NULL, NULL, &table);
    for (size_t i = 1; i < table.count && good; i++) {
        const scenes_row *row = &table.rows[i];
        char rel[BASE_NUMBER_SIZE], p99[BASE_NUMBER_SIZE];
        fprintf(out, "%s,%" PRIu64 ",%" PRIu64 ",%s,%s\n", row->pipeline,
                scenes_fragments(&row->statistics), row->statistics.visibility_rays,
                base_shortest_f64(row->error.rel, rel), base_shortest_f64(row->error.p99, p99));
    }
    scenes_table_free(&table);
    return good;
}

bool scenes_area_refinement(const scenes_plan *plan)
{
    return scenes_of_area_box(plan, "area_refinement.csv",
                              "pipeline,differing_bits,fragments,visibility_rays,rel,p99\n",
                              measure);
}
