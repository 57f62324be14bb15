/* exr.c: OpenEXR through its C core. The core writes into memory, so that files appear whole. */
#include "exr.h"

#include <openexr.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"
#include "text.h"

/* The core's own messages would be further lines on standard error. */
static void silent(exr_const_context_t context, exr_result_t code, const char *message)
{
    (void)context;
    (void)code;
    (void)message;
}

static int64_t into_buffer(exr_const_context_t context, void *user, const void *bytes,
                           uint64_t size, uint64_t offset, exr_stream_error_func_ptr_t error)
{
    (void)context;
    (void)error;
    buffer *out = user;
    size_t end = (size_t)(offset + size);
    if (end > out->length) { /* what is skipped is written later */
        if (end + 1 > out->capacity) {
            out->capacity = 2 * (end + 1);
            out->text = base_reallocate(out->text, out->capacity);
        }
        memset(out->text + out->length, 0, end + 1 - out->length);
        out->length = end;
    }
    memcpy(out->text + offset, bytes, size);
    return (int64_t)size;
}

/* The core keeps channels in the order of their names, whatever the order they were given in. */
static const exr_channel *find_channel(const exr_image *image, const char *name)
{
    size_t c = 0;
    while (strcmp(image->channels[c].name, name) != 0)
        c++;
    return &image->channels[c];
}

static exr_result_t write_rows(exr_context_t file, const exr_image *image)
{
    exr_encode_pipeline_t pipeline = EXR_ENCODE_PIPELINE_INITIALIZER;
    exr_result_t status = EXR_ERR_SUCCESS;
    for (int y = 0; status == EXR_ERR_SUCCESS && y < image->height; y++) {
        exr_chunk_info_t chunk;
        status = exr_write_scanline_chunk_info(file, 0, y, &chunk);
        if (status == EXR_ERR_SUCCESS)
            status = y == 0 ? exr_encoding_initialize(file, 0, &chunk, &pipeline)
                            : exr_encoding_update(file, 0, &chunk, &pipeline);
        if (status != EXR_ERR_SUCCESS)
            break;
        for (int16_t c = 0; c < pipeline.channel_count; c++) {
            exr_coding_channel_info_t *channel = &pipeline.channels[c];
            const exr_channel *from = find_channel(image, channel->channel_name);
            int stride = from->stride ? from->stride : 1;
            size_t row = (size_t)y * (size_t)image->width * (size_t)stride;
            channel->user_bytes_per_element = 4;
            channel->user_data_type = EXR_PIXEL_FLOAT;
            channel->user_pixel_stride = 4 * stride;
            channel->user_line_stride = 4 * stride * image->width;
            channel->encode_from_ptr = (const uint8_t *)(from->pixels + row);
        }
        if (y == 0)
            status = exr_encoding_choose_default_routines(file, 0, &pipeline);
        if (status == EXR_ERR_SUCCESS)
            status = exr_encoding_run(file, 0, &pipeline);
    }
    exr_encoding_destroy(file, &pipeline);
    return status;
}

static exr_result_t write_head(exr_context_t file, const exr_image *image)
{
    int part = 0;
    exr_result_t status = exr_add_part(file, NULL, EXR_STORAGE_SCANLINE, &part);
    if (status == EXR_ERR_SUCCESS)
        status = exr_initialize_required_attr_simple(file, part, image->width, image->height,
                                                     image->compressed ? EXR_COMPRESSION_ZIPS
                                                                       : EXR_COMPRESSION_NONE);
    for (size_t c = 0; status == EXR_ERR_SUCCESS && c < image->channel_count; c++)
        status = exr_add_channel(file, part, image->channels[c].name,
                                 image->half || image->channels[c].half ? EXR_PIXEL_HALF
                                                                        : EXR_PIXEL_FLOAT,
                                 EXR_PERCEPTUALLY_LINEAR, 1, 1);
    for (size_t i = 0; status == EXR_ERR_SUCCESS && i < image->attribute_count; i++)
        status =
            exr_attr_set_string(file, part, image->attributes[i].name, image->attributes[i].value);
    return status == EXR_ERR_SUCCESS ? exr_write_header(file) : status;
}

bool exr_write(const char *path, const exr_image *image)
{
    buffer bytes = {0};
    bool good = exr_encode(&bytes, image) && base_write_file(path, bytes.text, bytes.length);
    buffer_free(&bytes);
    return good;
}

bool exr_encode(buffer *out, const exr_image *image)
{
    exr_context_initializer_t setup = EXR_DEFAULT_CONTEXT_INITIALIZER;
    setup.error_handler_fn = silent;
    setup.user_data = out;
    setup.write_fn = into_buffer;
    exr_context_t file = NULL;
    exr_result_t status = exr_start_write(&file, "memory", EXR_WRITE_FILE_DIRECTLY, &setup);
    if (status == EXR_ERR_SUCCESS)
        status = write_head(file, image);
    if (status == EXR_ERR_SUCCESS)
        status = write_rows(file, image);
    exr_result_t finished = file ? exr_finish(&file) : EXR_ERR_SUCCESS;
    if (status == EXR_ERR_SUCCESS)
        status = finished;
    if (status != EXR_ERR_SUCCESS)
        base_error("cannot encode EXR: %s", exr_get_default_error_message(status));
    return status == EXR_ERR_SUCCESS;
}

static exr_result_t read_rows(exr_context_t file, const char *name, float *pixels, int width,
                              int height, int top)
{
    exr_decode_pipeline_t pipeline = EXR_DECODE_PIPELINE_INITIALIZER;
    exr_result_t status = EXR_ERR_SUCCESS;
    int32_t lines = 1;
    status = exr_get_scanlines_per_chunk(file, 0, &lines);
    for (int y = 0; status == EXR_ERR_SUCCESS && y < height; y += lines) {
        exr_chunk_info_t chunk;
        status = exr_read_scanline_chunk_info(file, 0, top + y, &chunk);
        if (status == EXR_ERR_SUCCESS)
            status = y == 0 ? exr_decoding_initialize(file, 0, &chunk, &pipeline)
                            : exr_decoding_update(file, 0, &chunk, &pipeline);
        if (status != EXR_ERR_SUCCESS)
            break;
        exr_coding_channel_info_t *wanted = NULL;
        for (int16_t c = 0; c < pipeline.channel_count; c++) {
            exr_coding_channel_info_t *channel = &pipeline.channels[c];
            channel->decode_to_ptr = NULL; /* not read */
            if (name ? strcmp(channel->channel_name, name) == 0 : pipeline.channel_count == 1)
                wanted = channel;
        }
        if (!wanted) {
            status = EXR_ERR_INVALID_ARGUMENT;
            break;
        }
        wanted->user_bytes_per_element = 4;
        wanted->user_data_type = EXR_PIXEL_FLOAT;
        wanted->user_pixel_stride = 4;
        wanted->user_line_stride = 4 * width;
        wanted->decode_to_ptr = (uint8_t *)(pixels + (size_t)y * (size_t)width);
        if (y == 0)
            status = exr_decoding_choose_default_routines(file, 0, &pipeline);
        if (status == EXR_ERR_SUCCESS)
            status = exr_decoding_run(file, 0, &pipeline);
    }
    exr_decoding_destroy(file, &pipeline);
    return status;
}

float *exr_read(const char *path, const char *channel, int *width, int *height)
{
    enum { LARGEST = 1 << 14 };
    exr_context_initializer_t setup = EXR_DEFAULT_CONTEXT_INITIALIZER;
    setup.error_handler_fn = silent;
    exr_context_t file = NULL;
    exr_attr_box2i_t window;
    float *pixels = NULL;
    exr_result_t status = exr_start_read(&file, path, &setup);
    if (status == EXR_ERR_SUCCESS)
        status = exr_get_data_window(file, 0, &window);
    if (status == EXR_ERR_SUCCESS) {
        *width = window.max.x - window.min.x + 1;
        *height = window.max.y - window.min.y + 1;
        if (*width < 1 || *height < 1 || *width > LARGEST || *height > LARGEST)
            status = EXR_ERR_INVALID_ATTR;
    }
    if (status == EXR_ERR_SUCCESS) {
        pixels = base_allocate((size_t)*width * (size_t)*height * sizeof *pixels);
        status = read_rows(file, channel, pixels, *width, *height, window.min.y);
    }
    exr_finish(&file);
    if (status != EXR_ERR_SUCCESS) {
        base_error("%s: expected an EXR image %s%s: %s", path,
                   channel ? "with a channel " : "of one channel", channel ? channel : "",
                   exr_get_default_error_message(status));
        free(pixels);
        pixels = NULL;
    }
    return pixels;
}
