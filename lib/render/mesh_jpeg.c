/* mesh_jpeg.c: see mesh_jpeg.h. */
#include "mesh_jpeg.h"

#include <stdio.h> /* jpeglib.h wants it first */

#include <jpeglib.h>
#include <setjmp.h>
#include <stdlib.h>

/* The library ends the program on damage unless it is led elsewhere. */
typedef struct handler {
    struct jpeg_error_mgr manager; /* first: the library knows this part */
    jmp_buf leave;
} handler;

static void leave(j_common_ptr info)
{
    longjmp(((handler *)(void *)info->err)->leave, 1);
}

/* Warnings, such as of a file that is cut off, count as damage. */
static void warn(j_common_ptr info, int level)
{
    if (level < 0)
        leave(info);
}

static bool read_rows(struct jpeg_decompress_struct *info, uint8_t *texels)
{
    while (info->output_scanline < info->output_height) {
        uint8_t *row = texels + 4 * (size_t)info->output_width * info->output_scanline;
        if (jpeg_read_scanlines(info, &row, 1) != 1)
            return false;
    }
    return jpeg_finish_decompress(info) != 0;
}

bool mesh_jpeg(const uint8_t *bytes, size_t size, unsigned longest, uint8_t **texels, size_t *count)
{
    struct jpeg_decompress_struct info;
    handler errors;
    *texels = NULL;
    info.err = jpeg_std_error(&errors.manager);
    errors.manager.error_exit = leave;
    errors.manager.emit_message = warn;
    if (setjmp(errors.leave)) {
        jpeg_destroy_decompress(&info);
        free(*texels);
        *texels = NULL;
        return false;
    }
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, bytes, (unsigned long)size);
    bool good = jpeg_read_header(&info, TRUE) == JPEG_HEADER_OK && info.image_width <= longest &&
                info.image_height <= longest;
    if (good) {
        info.out_color_space = JCS_EXT_RGBX;
        good = jpeg_start_decompress(&info) != 0;
    }
    if (good) {
        *count = (size_t)info.output_width * info.output_height;
        *texels = malloc(4 * *count + 1);
        good = *texels && read_rows(&info, *texels);
    }
    jpeg_destroy_decompress(&info);
    if (!good) {
        free(*texels);
        *texels = NULL;
    }
    for (size_t i = 0; good && i < *count; i++)
        (*texels)[4 * i + 3] = 255;
    return good;
}
