/* shaders.h: inside lib/render and its tests. */
#ifndef RENDER_SHADERS_H
#define RENDER_SHADERS_H

/* Paths of all built-in files below shaders/, those that are only included too; NULL past the
 * last one. */
const char *render_shader_path(int index);

#endif
