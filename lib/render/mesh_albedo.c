/* mesh_albedo.c: runs in the child process: one colour a material. */
#include "mesh_child.h"
#include "mesh_jpeg.h"

#include <assimp/material.h>
#include <math.h>
#include <png.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"

enum { LARGEST_SIDE = 1 << 14 };

static double linear_of(uint8_t encoded)
{
    double x = encoded / 255.0;
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

/* Mean colour of sRGB texels of 4 bytes, linear and weighted by alpha; order: where red, green,
 * blue and alpha stand. False where nothing is opaque. */
static bool mean_of_bytes(const uint8_t *texels, size_t count, const int order[4], double mean[3])
{
    double linear[256], sum[4] = {0};
    for (int i = 0; i < 256; i++)
        linear[i] = linear_of((uint8_t)i);
    for (size_t i = 0; i < count; i++) {
        double alpha = texels[4 * i + (size_t)order[3]];
        for (int c = 0; c < 3; c++)
            sum[c] += alpha * linear[texels[4 * i + (size_t)order[c]]];
        sum[3] += alpha;
    }
    for (int c = 0; c < 3; c++)
        mean[c] = sum[3] > 0 ? sum[c] / sum[3] : 0;
    return sum[3] > 0;
}

static const int rgba[4] = {0, 1, 2, 3};

static bool mean_of_png(const uint8_t *bytes, size_t size, double mean[3])
{
    png_image image = {.version = PNG_IMAGE_VERSION};
    bool good = png_image_begin_read_from_memory(&image, bytes, size) &&
                image.width <= LARGEST_SIDE && image.height <= LARGEST_SIDE;
    uint8_t *pixels = NULL;
    if (good) {
        image.format = PNG_FORMAT_RGBA;
        pixels = base_allocate(PNG_IMAGE_SIZE(image));
        good = png_image_finish_read(&image, NULL, pixels, 0, NULL) != 0 &&
               mean_of_bytes(pixels, (size_t)image.width * (size_t)image.height, rgba, mean);
    }
    free(pixels);
    png_image_free(&image);
    return good;
}

/* A whole PNG or JPEG file. */
static bool mean_of_file(const uint8_t *bytes, size_t size, double mean[3])
{
    uint8_t *texels;
    size_t count;
    if (size < 3 || memcmp(bytes, "\xff\xd8\xff", 3) != 0)
        return mean_of_png(bytes, size, mean);
    bool good = mesh_jpeg(bytes, size, LARGEST_SIDE, &texels, &count) &&
                mean_of_bytes(texels, count, rgba, mean);
    free(texels);
    return good;
}

/* A texture that cannot be read is no reason to say anything: the colour alone stands. */
static bool mean_at_path(const char *path, double mean[3])
{
    enum { STEP = 1 << 16, LARGEST_FILE = 1 << 28 };
    FILE *stream = fopen(path, "rb");
    if (!stream)
        return false;
    uint8_t *bytes = NULL;
    size_t size = 0, more;
    do {
        bytes = base_reallocate(bytes, size + STEP);
        more = fread(bytes + size, 1, STEP, stream);
        size += more;
    } while (more == STEP && size < LARGEST_FILE);
    fclose(stream);
    bool good = mean_of_file(bytes, size, mean);
    free(bytes);
    return good;
}

static bool mean_of_texels(const struct aiTexture *texture, double mean[3])
{
    static const int order[4] = {2, 1, 0, 3};
    return mean_of_bytes(&texture->pcData->b, (size_t)texture->mWidth * (size_t)texture->mHeight,
                         order, mean);
}

static bool mean_of_texture(const struct aiScene *from, const char *name, const char *folder,
                            double mean[3])
{
    if (name[0] == '*') { /* inside the file */
        unsigned long index = strtoul(name + 1, NULL, 10);
        if (index >= from->mNumTextures)
            return false;
        const struct aiTexture *texture = from->mTextures[index];
        if (texture->mHeight > 0)
            return mean_of_texels(texture, mean);
        return mean_of_file(&texture->pcData->b, texture->mWidth, mean);
    }
    buffer path = {0};
    if (name[0] != '/')
        buffer_add(&path, folder);
    buffer_add(&path, name);
    for (char *p = path.text; *p; p++)
        if (*p == '\\') /* as some exporters write folders */
            *p = '/';
    bool good = mean_at_path(path.text, mean);
    buffer_free(&path);
    return good;
}

void mesh_albedo(const struct aiScene *from, const struct aiMaterial *material, const char *folder,
                 float albedo[3])
{
    struct aiColor4D colour = {0.6F, 0.6F, 0.6F, 1};
    struct aiString name;
    double mean[3] = {1, 1, 1};
    bool made_up = aiGetMaterialString(material, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS &&
                   strcmp(name.data, AI_DEFAULT_MATERIAL_NAME) == 0;
    if (!made_up && aiGetMaterialColor(material, AI_MATKEY_BASE_COLOR, &colour) != aiReturn_SUCCESS)
        aiGetMaterialColor(material, AI_MATKEY_COLOR_DIFFUSE, &colour);
    for (int kind = 0; kind < 2; kind++) {
        enum aiTextureType type = kind == 0 ? aiTextureType_BASE_COLOR : aiTextureType_DIFFUSE;
        if (aiGetMaterialTexture(material, type, 0, &name, NULL, NULL, NULL, NULL, NULL, NULL) ==
            aiReturn_SUCCESS) {
            if (!mean_of_texture(from, name.data, folder, mean))
                mean[0] = mean[1] = mean[2] = 1;
            break;
        }
    }
    albedo[0] = colour.r * (float)mean[0];
    albedo[1] = colour.g * (float)mean[1];
    albedo[2] = colour.b * (float)mean[2];
}
