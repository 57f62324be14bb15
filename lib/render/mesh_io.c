/* mesh_io.c: runs in the child process: hands files to Assimp, one of them with other bytes than it
 * has on the disc. */
#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/file.h"
#include "mesh_child.h"

typedef struct replaced {
    const char *path;
    char *bytes;
    size_t size;
} replaced;

typedef struct opened {
    struct aiFile file;
    char *bytes;
    size_t size, at;
    bool own;
} opened;

static opened *of(struct aiFile *file)
{
    return (opened *)(void *)file->UserData;
}

static size_t read_some(struct aiFile *file, char *to, size_t size, size_t count)
{
    opened *from = of(file);
    size_t left = size > 0 ? (from->size - from->at) / size : 0;
    count = count < left ? count : left;
    memcpy(to, from->bytes + from->at, count * size);
    from->at += count * size;
    return count;
}

static size_t write_nothing(struct aiFile *file, const char *from, size_t size, size_t count)
{
    (void)file, (void)from, (void)size, (void)count;
    return 0;
}

static size_t tell(struct aiFile *file)
{
    return of(file)->at;
}

static size_t size_of(struct aiFile *file)
{
    return of(file)->size;
}

static enum aiReturn seek(struct aiFile *file, size_t offset, enum aiOrigin origin)
{
    opened *in = of(file);
    size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? in->at : in->size;
    if (base + offset > in->size) /* one before base wraps round to where it belongs */
        return aiReturn_FAILURE;
    in->at = base + offset;
    return aiReturn_SUCCESS;
}

static void flush(struct aiFile *file)
{
    (void)file;
}

static struct aiFile *open_file(struct aiFileIO *io, const char *path, const char *mode)
{
    const replaced *other = (const replaced *)(void *)io->UserData;
    (void)mode;
    opened in = {.bytes = other->bytes, .size = other->size};
    if (strcmp(path, other->path) != 0) {
        in.own = true;
        in.bytes = base_read_file(path, &in.size);
        if (!in.bytes)
            return NULL;
    }
    opened *result = base_allocate(sizeof *result);
    in.file = (struct aiFile){.ReadProc = read_some,
                              .WriteProc = write_nothing,
                              .TellProc = tell,
                              .FileSizeProc = size_of,
                              .SeekProc = seek,
                              .FlushProc = flush,
                              .UserData = (char *)result};
    *result = in;
    return &result->file;
}

static void close_file(struct aiFileIO *io, struct aiFile *file)
{
    (void)io;
    if (of(file)->own)
        free(of(file)->bytes);
    free(of(file));
}

const struct aiScene *mesh_import_bytes(const char *path, char *bytes, size_t size,
                                        const struct aiPropertyStore *settings)
{
    replaced other = {.path = path, .bytes = bytes, .size = size};
    struct aiFileIO io = {
        .OpenProc = open_file, .CloseProc = close_file, .UserData = (char *)&other};
    return aiImportFileExWithProperties(path, aiProcess_ValidateDataStructure, &io, settings);
}
