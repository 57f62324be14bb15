/* mesh_child.h: what the child process does, and what it writes into its pipe. */
#ifndef RENDER_MESH_CHILD_H
#define RENDER_MESH_CHILD_H

#include <assimp/cimport.h>
#include <assimp/scene.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* First comes a head; where it says failed, a line of text without NUL follows to the end; else
 * positions, normals, indices, materials and albedos, as counted. */
enum { MESH_MAGIC = 0x6d657368 };
typedef struct mesh_head {
    uint32_t magic, failed;
    uint64_t vertices, triangles, materials, left_out;
} mesh_head;

/* Reads the file and writes to the pipe. Never returns. */
_Noreturn void mesh_child(const char *path, int pipe);

/* False, with the reason as text, where the file ends before what its header promises. */
enum { MESH_WHY = 120 };
bool mesh_ply_is_whole(const char *path, char why[MESH_WHY]);

/* The text of an OBJ file, a NUL behind its size bytes, in statements that Assimp reads right:
 * malloc'ed. text is used up. False, with the reason as text, where a vertex, a normal or a face
 * cannot be read. */
bool mesh_obj(char *text, size_t size, char **mended, size_t *mended_size, char why[MESH_WHY]);

/* aiImportFileExWithProperties, validated only, of a file that has these bytes; files that it names
 * are read from the disc. */
const struct aiScene *mesh_import_bytes(const char *path, char *bytes, size_t size,
                                        const struct aiPropertyStore *settings);

/* Linear base colour of a material of a file in this folder ("" or with its slash). */
void mesh_albedo(const struct aiScene *from, const struct aiMaterial *material, const char *folder,
                 float albedo[3]);

#endif
