/* scenes_command.c: `sgfit bench --scenes`. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/options.h"
#include "base/text.h"
#include "scenes.h"
#include "scenes_command.h"

static bool is_lit_by_area(const char *name)
{
    static const char ending[] = "_area.json";
    size_t length = strlen(name);
    return length >= sizeof ending - 1 && strcmp(name + length - (sizeof ending - 1), ending) == 0;
}

bool scenes_list(const scenes_plan *plan, bool area, char ***paths, size_t *count)
{
    char *folder = base_join(base_source_root(), "tests/scenes");
    const char *begin = plan->only ? plan->only : plan->folder ? "" : "box";
    bool good = base_list(folder, ".json", paths, count);
    size_t kept = 0;
    for (size_t i = 0; good && i < *count; i++) {
        char *name = (*paths)[i];
        if (strncmp(name, begin, strlen(begin)) == 0 && is_lit_by_area(name) == area)
            (*paths)[kept++] = base_join(folder, name);
        free(name);
    }
    if (good)
        *count = kept;
    free(folder);
    if (good && kept == 0 && !area) {
        base_error("bench: expected --view to begin like a description in tests/scenes, found %s",
                   begin);
        base_list_free(*paths, 0);
        return false;
    }
    return good;
}

bool scenes_of_box(const scenes_plan *plan, const char *name, const char *header, scenes_work work)
{
    render_scene scene;
    char *path = render_scene_default(), *csv = base_join(plan->out, name);
    bool good = render_scene_read(path, plan->folder, &scene);
    if (good) {
        base_output output;
        good = base_output_open(&output, csv);
        if (good) {
            fputs(header, output.stream);
            good = work(plan, &scene, output.stream);
            if (good)
                good = base_output_close(&output);
            else
                base_output_discard(&output);
        }
        render_scene_free(&scene);
    }
    free(path);
    free(csv);
    return good;
}

static bool folder_is_there(const char *folder)
{
    char **names;
    size_t count;
    if (!base_list(folder, "", &names, &count))
        return false;
    base_list_free(names, count);
    return true;
}

int scenes_command(const char *folder, const char *only, const char *device, const char *out,
                   bool quick)
{
    scenes_plan plan = {.folder = strcmp(folder, "built-in") == 0 ? NULL : folder,
                        .out = out,
                        .quick = quick,
                        .only = only};
    if (plan.folder && !folder_is_there(plan.folder))
        return BASE_USAGE;
    if (gpu_device_open(&(gpu_device_options){.device = device}, &plan.device) != GPU_OK) {
        base_error("bench: %s", gpu_last_error());
        return BASE_FAILED;
    }
    bool good = base_make_directory(out) && scenes_views(&plan) && scenes_rates(&plan) &&
                scenes_paper(&plan) && scenes_growth(&plan) && scenes_flicker(&plan) &&
                scenes_shadows(&plan) && scenes_lobes(&plan) && scenes_choice(&plan);
    gpu_device_close(plan.device);
    return good ? BASE_DONE : BASE_FAILED;
}
