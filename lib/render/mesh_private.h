/* mesh_private.h: between the files that read meshes. */
#ifndef RENDER_MESH_PRIVATE_H
#define RENDER_MESH_PRIVATE_H

#include "mesh.h"

/* Where FILE.materials.tsv stands beside path, its albedos replace those of the mesh. False after
 * one line where it is damaged. */
bool mesh_read_materials(const char *path, mesh *result);

#endif
