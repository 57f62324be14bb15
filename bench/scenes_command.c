/* scenes_command.c: `sgfit bench --scenes`. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

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

bool scenes_is_first_view(const char *path)
{
    size_t length = strlen(path) - strlen(".json");
    return length < 2 || path[length - 2] != '_' || path[length - 1] < '0' ||
           path[length - 1] > '9';
}

static bool find_scenes(const scenes_plan *plan, bool area, char ***paths, size_t *count)
{
    char *folder = base_join(base_source_root(), "tests/scenes");
    const char *begin = plan->only ? plan->only : plan->folder ? "" : "box";
    bool good = base_list(folder, ".json", paths, count);
    size_t kept = 0;
    for (size_t i = 0; good && i < *count; i++) {
        char *name = (*paths)[i];
        bool further = plan->quick && !plan->only && !scenes_is_first_view(name);
        if (strncmp(name, begin, strlen(begin)) == 0 && is_lit_by_area(name) == area && !further)
            (*paths)[kept++] = base_join(folder, name);
        free(name);
    }
    if (good)
        *count = kept;
    free(folder);
    return good;
}

static void tell_no_view(const scenes_plan *plan)
{
    base_error("bench: expected --view to begin like a description in tests/scenes, found %s",
               plan->only ? plan->only : "none there");
}

bool scenes_list(const scenes_plan *plan, bool area, char ***paths, size_t *count)
{
    if (!find_scenes(plan, area, paths, count))
        return false;
    if (*count == 0 && !area) {
        tell_no_view(plan);
        base_list_free(*paths, 0);
        return false;
    }
    return true;
}

static bool of_scene(const scenes_plan *plan, const char *path, const char *name,
                     const char *header, scenes_work work)
{
    render_scene scene;
    char *csv = base_join(plan->out, name);
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
    free(csv);
    return good;
}

bool scenes_of_box(const scenes_plan *plan, const char *name, const char *header, scenes_work work)
{
    char *path = render_scene_default();
    bool good = of_scene(plan, path, name, header, work);
    free(path);
    return good;
}

bool scenes_of_area_box(const scenes_plan *plan, const char *name, const char *header,
                        scenes_work work)
{
    char *path = base_join(base_source_root(), "tests/scenes/box_area.json");
    bool good = of_scene(plan, path, name, header, work);
    free(path);
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

/* Whether all scenes that the parts measure are there: one that is not would be told of hours
 * later. */
static bool scenes_are_there(const scenes_plan *plan)
{
    bool good = true;
    size_t all = 0;
    for (int area = 0; area < 2 && good; area++) {
        char **paths;
        size_t count;
        if (!find_scenes(plan, area, &paths, &count))
            return false;
        all += count;
        for (size_t i = 0; i < count && good; i++)
            good = render_scene_is_there(paths[i], plan->folder);
        base_list_free(paths, count);
    }
    if (good && all == 0)
        tell_no_view(plan);
    return good && all > 0;
}

/* ---- Parts ------------------------------------------------------------------------------------
 */

/* What looks at the built-in scenes alone. */
static const char of_box[] = " growth flicker area_refinement area_flicker lobes choice ";

static const struct {
    const char *name;
    bool (*run)(const scenes_plan *plan);
} parts[] = {
#define PART(NAME) {#NAME, scenes_##NAME},
    SCENES_PARTS(PART) SCENES_EXTRA_PARTS(PART)
#undef PART
};
#define COUNT(NAME) +1
enum { USUAL_PARTS = SCENES_PARTS(COUNT), PARTS = sizeof parts / sizeof *parts };
#undef COUNT

static size_t find_part(const char *name, size_t length)
{
    size_t i = 0;
    while (i < PARTS &&
           (strlen(parts[i].name) != length || memcmp(parts[i].name, name, length) != 0))
        i++;
    return i;
}

/* wanted: of every part. False after one line that names what is no part. */
static bool choose_parts(const char *list, bool wanted[PARTS])
{
#define NAME(PART) " " #PART
    static const char names[] = SCENES_PARTS(NAME) SCENES_EXTRA_PARTS(NAME);
#undef NAME
    for (size_t i = 0; i < PARTS; i++)
        wanted[i] = list == NULL && i < USUAL_PARTS;
    while (list) {
        size_t length = strcspn(list, ","), part = find_part(list, length);
        if (part == PARTS) {
            base_error("bench: expected --part to name some of%s, with commas between, found "
                       "\"%.*s\"",
                       names, (int)length, list);
            return false;
        }
        wanted[part] = true;
        list = list[length] ? list + length + 1 : NULL;
    }
    return true;
}

/* Whether a part is wanted that takes the scenes of the folder. */
static bool wants_scenes(const bool wanted[PARTS])
{
    bool wants = false;
    for (size_t i = 0; i < PARTS; i++) {
        char name[64];
        snprintf(name, sizeof name, " %s ", parts[i].name);
        wants = wants || (wanted[i] && !strstr(of_box, name));
    }
    return wants;
}

/* Each part writes its files when it ends: they stay where a later one fails. */
static bool run_parts(const scenes_plan *plan, const bool wanted[PARTS])
{
    size_t remain = 0;
    for (size_t i = 0; i < PARTS; i++)
        remain += wanted[i];
    bool good = true, shows = isatty(STDERR_FILENO) != 0;
    for (size_t i = 0; i < PARTS && good; i++) {
        if (!wanted[i])
            continue;
        struct timespec begun, ended;
        clock_gettime(CLOCK_MONOTONIC, &begun);
        good = parts[i].run(plan);
        clock_gettime(CLOCK_MONOTONIC, &ended);
        remain--;
        if (good && shows)
            fprintf(stderr, "%s: done in %ld s; parts that remain: %zu\n", parts[i].name,
                    (long)(ended.tv_sec - begun.tv_sec), remain);
    }
    return good;
}

int scenes_command(const scenes_request *request)
{
    scenes_warmth warm = {.count = 0};
    scenes_plan plan = {.folder = strcmp(request->folder, "built-in") == 0 ? NULL : request->folder,
                        .out = request->out,
                        .quick = request->quick,
                        .only = request->only,
                        .warm = &warm};
    bool wanted[PARTS];
    if (!choose_parts(request->parts, wanted) || (plan.folder && !folder_is_there(plan.folder)) ||
        (wants_scenes(wanted) && !scenes_are_there(&plan)))
        return BASE_USAGE;
    if (!base_can_fill(plan.out))
        return BASE_FAILED;
    if (gpu_device_open(&(gpu_device_options){.device = request->device}, &plan.device) != GPU_OK) {
        base_error("bench: %s", gpu_last_error());
        return BASE_FAILED;
    }
    bool good = base_make_directory(plan.out) && run_parts(&plan, wanted);
    gpu_device_close(plan.device);
    return good ? BASE_DONE : BASE_FAILED;
}
