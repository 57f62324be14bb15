/* mesh_child.c: runs in the child process: Assimp's scene becomes flat arrays in a pipe. Whatever
 * happens here ends with this process. */
#include "mesh_child.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "base/buffer.h"
#include "base/file.h"

enum { DEEPEST = 1000 }; /* nodes below each other */

typedef struct flat {
    float unit; /* of Assimp's coordinates, in those of the file */
    buffer positions, normals, indices, materials;
    mesh_head head;
} flat;

static void send_bytes(int pipe, const void *bytes, size_t size)
{
    const char *next = bytes;
    while (size > 0) {
        ssize_t sent = write(pipe, next, size);
        if (sent <= 0)
            _exit(1); /* nobody listens any more */
        next += sent;
        size -= (size_t)sent;
    }
}

static _Noreturn void fail(int pipe, const char *why)
{
    mesh_head head = {.magic = MESH_MAGIC, .failed = 1};
    char line[200];
    size_t length = 0;
    for (; why[length] && length < sizeof line; length++)
        line[length] = why[length] >= ' ' && why[length] <= '~' ? why[length] : ' ';
    while (length > 0 && line[length - 1] == ' ')
        length--;
    send_bytes(pipe, &head, sizeof head);
    send_bytes(pipe, line, length);
    _exit(0);
}

static void add_vertices(flat *out, const struct aiMesh *from, const struct aiMatrix4x4 *m)
{
    for (unsigned i = 0; i < from->mNumVertices; i++) {
        const struct aiVector3D *q = &from->mVertices[i];
        const struct aiVector3D p = {q->x * out->unit, q->y * out->unit, q->z * out->unit};
        const struct aiVector3D none = {0, 0, 0}, *n = from->mNormals ? &from->mNormals[i] : &none;
        float position[3] = {m->a1 * p.x + m->a2 * p.y + m->a3 * p.z + m->a4,
                             m->b1 * p.x + m->b2 * p.y + m->b3 * p.z + m->b4,
                             m->c1 * p.x + m->c2 * p.y + m->c3 * p.z + m->c4};
        /* The matrix of cofactors: right for normals whatever the matrix does to lengths. */
        float normal[3] = {
            (m->b2 * m->c3 - m->b3 * m->c2) * n->x + (m->b3 * m->c1 - m->b1 * m->c3) * n->y +
                (m->b1 * m->c2 - m->b2 * m->c1) * n->z,
            (m->a3 * m->c2 - m->a2 * m->c3) * n->x + (m->a1 * m->c3 - m->a3 * m->c1) * n->y +
                (m->a2 * m->c1 - m->a1 * m->c2) * n->z,
            (m->a2 * m->b3 - m->a3 * m->b2) * n->x + (m->a3 * m->b1 - m->a1 * m->b3) * n->y +
                (m->a1 * m->b2 - m->a2 * m->b1) * n->z};
        buffer_add_n(&out->positions, (const char *)position, sizeof position);
        buffer_add_n(&out->normals, (const char *)normal, sizeof normal);
    }
}

static void add_mesh(flat *out, const struct aiMesh *from, const struct aiMatrix4x4 *m)
{
    uint64_t base = out->head.vertices;
    if (base + from->mNumVertices > UINT32_MAX)
        _exit(1);
    float determinant = m->a1 * (m->b2 * m->c3 - m->b3 * m->c2) -
                        m->a2 * (m->b1 * m->c3 - m->b3 * m->c1) +
                        m->a3 * (m->b1 * m->c2 - m->b2 * m->c1);
    add_vertices(out, from, m);
    out->head.vertices += from->mNumVertices;
    for (unsigned i = 0; i < from->mNumFaces; i++) {
        const struct aiFace *face = &from->mFaces[i];
        if (face->mNumIndices != 3) {
            out->head.left_out++;
            continue;
        }
        /* A mirrored triangle runs the other way round. */
        int second = determinant < 0 ? 2 : 1;
        uint64_t corners[3] = {base + face->mIndices[0], base + face->mIndices[second],
                               base + face->mIndices[3 - second]};
        uint32_t indices[3];
        for (int k = 0; k < 3; k++) /* a wild one stays wild for the parent to see */
            indices[k] = corners[k] < base + from->mNumVertices ? (uint32_t)corners[k] : UINT32_MAX;
        uint32_t material = from->mMaterialIndex;
        buffer_add_n(&out->indices, (const char *)indices, sizeof indices);
        buffer_add_n(&out->materials, (const char *)&material, sizeof material);
        out->head.triangles++;
    }
}

static void add_node(flat *out, const struct aiScene *from, const struct aiNode *node,
                     struct aiMatrix4x4 above, int depth)
{
    if (depth > DEEPEST)
        _exit(1);
    aiMultiplyMatrix4(&above, &node->mTransformation);
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        if (node->mMeshes[i] >= from->mNumMeshes)
            _exit(1);
        add_mesh(out, from->mMeshes[node->mMeshes[i]], &above);
    }
    for (unsigned i = 0; i < node->mNumChildren; i++)
        add_node(out, from, node->mChildren[i], above, depth + 1);
}

static const struct aiScene *import(const char *path, int pipe)
{
    char why[MESH_WHY];
    const char *dot = strrchr(path, '.');
    if (dot && strcasecmp(dot, ".ply") == 0 && !mesh_ply_is_whole(path, why))
        fail(pipe, why);
    struct aiPropertyStore *settings = aiCreatePropertyStore();
    /* Only positions and normals make vertices different. */
    aiSetImportPropertyInteger(settings, AI_CONFIG_PP_RVC_FLAGS,
                               aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                                   aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS |
                                   aiComponent_ANIMATIONS | aiComponent_LIGHTS |
                                   aiComponent_CAMERAS);
    if (!dot || strcasecmp(dot, ".obj") != 0)
        return aiImportFileExWithProperties(path, aiProcess_ValidateDataStructure, NULL, settings);
    size_t size, mended_size;
    char *text = base_read_file(path, &size), *mended = NULL;
    if (!text)
        fail(pipe, "it cannot be read");
    if (!mesh_obj(text, size, &mended, &mended_size, why))
        fail(pipe, why);
    free(text);
    return mesh_import_bytes(path, mended, mended_size, settings);
}

/* Assimp cuts polygons and joins vertices with lengths such as 1e-5 in mind, whatever the unit.
 * What is small is enlarged by a power of two before, which changes no digit. */
static const struct aiScene *enlarge(const struct aiScene *from, float *unit)
{
    const float enough = 1.0F / 64;
    float most = 0;
    for (unsigned i = 0; i < from->mNumMeshes; i++)
        for (unsigned k = 0; k < from->mMeshes[i]->mNumVertices; k++) {
            const struct aiVector3D *p = &from->mMeshes[i]->mVertices[k];
            most = fmaxf(most, fmaxf(fabsf(p->x), fmaxf(fabsf(p->y), fabsf(p->z))));
        }
    int exponent = 0;
    if (most > 0 && most < enough)
        frexpf(most, &exponent);
    exponent = exponent < -100 ? -100 : exponent;
    *unit = ldexpf(1, exponent);
    for (unsigned i = 0; i < from->mNumMeshes && exponent < 0; i++)
        for (unsigned k = 0; k < from->mMeshes[i]->mNumVertices; k++) {
            struct aiVector3D *p = &from->mMeshes[i]->mVertices[k];
            p->x /= *unit;
            p->y /= *unit;
            p->z /= *unit;
        }
    return aiApplyPostProcessing(from, aiProcess_Triangulate | aiProcess_RemoveComponent |
                                           aiProcess_JoinIdenticalVertices);
}

_Noreturn void mesh_child(const char *path, int pipe)
{
    flat out = {.head = {.magic = MESH_MAGIC}};
    const struct aiScene *from = import(path, pipe);
    from = from ? enlarge(from, &out.unit) : NULL;
    if (!from || !from->mRootNode)
        fail(pipe, aiGetErrorString());
    struct aiMatrix4x4 identity;
    aiIdentityMatrix4(&identity);
    add_node(&out, from, from->mRootNode, identity, 0);

    out.head.materials = from->mNumMaterials;
    send_bytes(pipe, &out.head, sizeof out.head);
    send_bytes(pipe, out.positions.text, out.positions.length);
    send_bytes(pipe, out.normals.text, out.normals.length);
    send_bytes(pipe, out.indices.text, out.indices.length);
    send_bytes(pipe, out.materials.text, out.materials.length);

    const char *slash = strrchr(path, '/');
    char *folder = base_copy(path, slash ? (size_t)(slash + 1 - path) : 0);
    for (unsigned i = 0; i < from->mNumMaterials; i++) {
        float albedo[3];
        mesh_albedo(from, from->mMaterials[i], folder, albedo);
        send_bytes(pipe, albedo, sizeof albedo);
    }
    _exit(0); /* nothing is given back: the process ends */
}
