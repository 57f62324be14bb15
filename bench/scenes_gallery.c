/* scenes_gallery.c: see scenes_gallery.h. */
#include "scenes_gallery.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"
#include "render/output.h"

/* Pipelines of which pictures are kept. */
static const char *const shown[] = {"exact",   "meder",    "hull",    "hull_lobe", "upsample4",
                                    "shadows", "multires", "nichols", NULL};

static bool is_shown(const char *id)
{
    for (size_t i = 0; shown[i]; i++)
        if (strcmp(shown[i], id) == 0)
            return true;
    return false;
}

static bool light_differs(const scenes_row *row, const float *light, const float *truth)
{
    return memcmp(light, truth, (size_t)row->width * row->height * 4 * sizeof *light) != 0;
}

bool scenes_write_image(const char *folder, const char *what, const scenes_row *row,
                        render_frame *frame)
{
    float *image;
    char name[3 * SCENES_NAME];
    snprintf(name, sizeof name, "%s_%s.png", row->scene, what);
    char *path = base_join(folder, name);
    bool good = output_read_image(frame->image, &image) == GPU_OK;
    if (good) {
        good = output_png(path, (int)row->width, (int)row->height, image, frame->gain);
        free(image);
    } else {
        base_error("%s: %s", path, gpu_last_error());
    }
    free(path);
    return good;
}

bool scenes_gallery(void *context, render_frame *frame, const scenes_row *row, const float *light,
                    const float *truth, const float *errors)
{
    const char *folder = context; /* NULL: no pictures of this view */
    if (!folder || !is_shown(row->pipeline))
        return true;
    bool good = scenes_write_image(folder, row->pipeline, row, frame);
    if (good && light_differs(row, light, truth)) {
        char name[3 * SCENES_NAME];
        snprintf(name, sizeof name, "%s_%s_errors.png", row->scene, row->pipeline);
        char *path = base_join(folder, name);
        good = scenes_write_errors(path, row->width, row->height, errors, truth);
        free(path);
    }
    return good;
}
