/* scenes_gallery.h: pictures of what scenes_measure renders. Private to bench. */
#ifndef BENCH_SCENES_GALLERY_H
#define BENCH_SCENES_GALLERY_H

#include "scenes.h"

/* A scenes_look. context: the folder (char *), or NULL for no pictures: SCENE_PIPELINE.png and, but
 * of the truth, SCENE_PIPELINE_errors.png, of those pipelines that the report shows. */
bool scenes_gallery(void *context, render_frame *frame, const scenes_row *row, const float *light,
                    const float *truth, const float *errors);

#endif
