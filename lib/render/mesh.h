/* mesh.h: one mesh file (OBJ, PLY, glTF, GLB) as flat arrays.
 *
 * Files are read by Assimp in a child process with limits of time and memory: a damaged one may
 * abort or hang there, and ends here in one line. */
#ifndef RENDER_MESH_H
#define RENDER_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct mesh {
    size_t vertex_count, triangle_count, material_count;
    size_t left_out;     /* faces that are points or lines */
    float *positions;    /* 3 a vertex, the file's transforms of nodes applied; may be NaN */
    float *normals;      /* 3 a vertex; not always of length 1, may be NaN; 0 where there is none */
    uint32_t *indices;   /* 3 a triangle, below vertex_count */
    uint32_t *materials; /* 1 a triangle, below material_count */
    float *albedos;      /* 3 a material, linear, in [0, 1] */
} mesh;

typedef struct mesh_limits {
    double seconds;  /* 0 counts as 60 */
    uint64_t memory; /* bytes beyond what this process has; 0 counts as 4 GiB */
} mesh_limits;

/* Albedo is the material's diffuse or base colour, taken as linear, times the mean of its texture
 * where that is a PNG that can be read (sRGB to linear, weighted by alpha); 0.6 where a file has
 * no materials. Where FILE.materials.tsv stands beside FILE.obj, its albedos win: a header line,
 * then a line a material in the order of the file, tab-separated; the columns are those named
 * mean_linear_albedo_r, g and b.
 *
 * limits: NULL for the usual ones. False after one line that names the file; result is then empty.
 */
bool mesh_read(const char *path, const mesh_limits *limits, mesh *result);
void mesh_free(mesh *result);

#endif
