/* scenes_area.h: what the parts of the bench on area lights with shadows share. */
#ifndef BENCH_SCENES_AREA_H
#define BENCH_SCENES_AREA_H

#include "scenes.h"

/* Of all levels. */
uint64_t scenes_fragments(const render_statistics *statistics);

/* The fragments of a pipeline that dumps them, as a picture. False after one line. */
bool scenes_fragment_map(const scenes_plan *plan, const render_scene *scene, uint32_t width,
                         uint32_t height, const char *pipeline, const char *path);

#endif
