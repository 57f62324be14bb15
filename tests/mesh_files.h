/* mesh_files.h: a tetrahedron of volume 1/6 in every format that meshes are read from. */
#ifndef TESTS_MESH_FILES_H
#define TESTS_MESH_FILES_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/buffer.h"

static const char mesh_file_obj[] =
    "# tetrahedron\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/* Two pixels: sRGB 255 188 0 and 0 188 0. */
static const uint8_t mesh_file_png[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44,
    0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00, 0x00, 0x7b,
    0x40, 0xe8, 0xdd, 0x00, 0x00, 0x00, 0x0f, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0xf8,
    0xbf, 0x87, 0x81, 0x61, 0x0f, 0x03, 0x00, 0x0b, 0x25, 0x02, 0x78, 0x99, 0xc1, 0xf9, 0x8f,
    0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

static const float mesh_file_corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
static const uint32_t mesh_file_faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

/* whole: as many faces as the header says, else one fewer. */
static inline buffer mesh_file_ply(bool binary, bool whole)
{
    buffer out = {0};
    buffer_print(&out,
                 "ply\nformat %s 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                 "property float z\nelement face 4\nproperty list uchar int vertex_indices\n"
                 "end_header\n",
                 binary ? "binary_little_endian" : "ascii");
    for (int i = 0; i < 4; i++) {
        const float *p = mesh_file_corners[i];
        if (binary)
            buffer_add_n(&out, (const char *)p, 12);
        else
            buffer_print(&out, "%g %g %g\n", (double)p[0], (double)p[1], (double)p[2]);
    }
    for (int i = 0; i < (whole ? 4 : 3); i++) {
        const uint32_t *f = mesh_file_faces[i];
        if (binary) {
            buffer_add_n(&out, "\3", 1);
            buffer_add_n(&out, (const char *)f, 12);
        } else {
            buffer_print(&out, "3 %u %u %u\n", f[0], f[1], f[2]);
        }
    }
    return out;
}

/* A node above the mesh scales by scale and moves along x; first replaces the first index. */
static inline buffer mesh_file_glb(float scale, float x, uint32_t first)
{
    buffer json = {0}, out = {0};
    buffer_print(&json,
                 "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
                 "\"nodes\":[{\"translation\":[%g,0,0],\"children\":[1]},"
                 "{\"scale\":[%g,%g,%g],\"mesh\":0}],"
                 "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
                 "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,"
                 "\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,1]},"
                 "{\"bufferView\":1,\"componentType\":5125,\"count\":12,\"type\":\"SCALAR\"}],"
                 "\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":48},"
                 "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":48}],"
                 "\"buffers\":[{\"byteLength\":96}]}",
                 (double)x, (double)scale, (double)scale, (double)scale);
    while (json.length % 4)
        buffer_add(&json, " ");
    uint32_t faces[12];
    memcpy(faces, mesh_file_faces, sizeof faces);
    faces[0] = first;
    const uint32_t length = (uint32_t)json.length;
    const uint32_t head[5] = {0x46546c67, 2, 12 + 8 + length + 8 + 96, length, 0x4e4f534a};
    const uint32_t second[2] = {96, 0x004e4942};
    buffer_add_n(&out, (const char *)head, sizeof head);
    buffer_add_n(&out, json.text, json.length);
    buffer_add_n(&out, (const char *)second, sizeof second);
    buffer_add_n(&out, (const char *)mesh_file_corners, 48);
    buffer_add_n(&out, (const char *)faces, 48);
    buffer_free(&json);
    return out;
}

#endif
