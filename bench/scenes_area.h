/* scenes_area.h: what the parts of the bench on area lights with shadows share. */
#ifndef BENCH_SCENES_AREA_H
#define BENCH_SCENES_AREA_H

#include "scenes.h"

/* Of all levels. */
uint64_t scenes_fragments(const render_statistics *statistics);

#endif
