#include "file.h"

#include "text.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void forget(base_output *output)
{
    free(output->path);
    free(output->temporary);
    *output = (base_output){0};
}

/* Creates an empty file beside path that nothing else has; its name in *name. */
static int create_beside(const char *path, char **name)
{
    size_t size = strlen(path) + 48;
    *name = malloc(size);
    if (!*name)
        return -1;
    for (unsigned attempt = 0; attempt < 1000; attempt++) {
        snprintf(*name, size, "%s.%ld-%u.part", path, (long)getpid(), attempt);
        /* Mode 0666 minus the umask, as any program that writes a file; mkstemp would hide it. */
        int file = open(*name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST)
            return file;
    }
    return -1;
}

bool base_output_open(base_output *output, const char *path)
{
    *output = (base_output){0};
    struct stat status;
    bool exists = stat(path, &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) {
        base_error("cannot write %s: it is a directory, expected a file", path);
        return false;
    }
    int file;
    if (exists && !S_ISREG(status.st_mode)) {
        /* A device or pipe has no other place to be written and must not be replaced. */
        output->path = strdup(path);
        file = open(path, O_WRONLY | O_CLOEXEC);
    } else {
        /* A link keeps pointing at its file: the file is what is replaced. */
        output->path = exists ? realpath(path, NULL) : strdup(path);
        file = output->path ? create_beside(output->path, &output->temporary) : -1;
    }
    output->stream = file >= 0 ? fdopen(file, "w") : NULL;
    if (output->stream)
        return true;
    int reason = errno;
    if (file >= 0) {
        close(file);
        if (output->temporary)
            unlink(output->temporary);
    }
    forget(output);
    base_error("cannot write %s: %s", path, strerror(reason));
    return false;
}

/* Everything reached the disk; errno says why not. */
static bool flush_to_disk(FILE *stream)
{
    errno = 0;
    if (fflush(stream) != 0 || ferror(stream)) {
        /* Which write failed first is forgotten by now, and why: another will tell. */
        if (errno == 0 && write(fileno(stream), "", 1) >= 0)
            errno = EIO;
        return false;
    }
    /* Pipes and devices cannot be synchronised, and need not be. */
    return fsync(fileno(stream)) == 0 || errno == EINVAL || errno == EROFS || errno == ENOTSUP;
}

bool base_output_close(base_output *output)
{
    if (!output->stream)
        return false;
    bool good = flush_to_disk(output->stream);
    int reason = errno;
    if (fclose(output->stream) != 0 && good) {
        good = false;
        reason = errno;
    }
    if (good && output->temporary && rename(output->temporary, output->path) != 0) {
        good = false;
        reason = errno;
    }
    if (!good) {
        if (output->temporary)
            unlink(output->temporary);
        base_error("cannot write %s: %s", output->path, strerror(reason));
    }
    forget(output);
    return good;
}

void base_output_discard(base_output *output)
{
    if (output->stream) {
        fclose(output->stream);
        if (output->temporary)
            unlink(output->temporary);
    }
    forget(output);
}

bool base_write_file(const char *path, const void *bytes, size_t size)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    /* A short write leaves the stream's error flag, which close reports. */
    if (size > 0)
        (void)!fwrite(bytes, 1, size, output.stream);
    return base_output_close(&output);
}

bool base_can_write(const char *path)
{
    struct stat status;
    if (stat(path, &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
        /* Whoever reads from a pipe would take opening it for the output. */
        if (access(path, W_OK) == 0)
            return true;
        base_error("cannot write %s: %s", path, strerror(errno));
        return false;
    }
    base_output trial;
    if (!base_output_open(&trial, path))
        return false;
    base_output_discard(&trial);
    return true;
}

char *base_read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        base_error("cannot read %s: %s", path, strerror(errno));
        return NULL;
    }
    char *bytes = NULL;
    size_t used = 0, capacity = 0;
    int reason = 0;
    for (;;) {
        if (capacity - used < 2) {
            capacity = capacity ? 2 * capacity : 1 << 14;
            char *grown = realloc(bytes, capacity);
            if (!grown) {
                reason = ENOMEM;
                break;
            }
            bytes = grown;
        }
        errno = 0;
        size_t got = fread(bytes + used, 1, capacity - used - 1, file);
        used += got;
        if (ferror(file))
            reason = errno ? errno : EIO;
        if (got == 0 || reason)
            break;
    }
    fclose(file);
    if (reason) {
        free(bytes);
        base_error("cannot read %s: %s", path, strerror(reason));
        return NULL;
    }
    bytes[used] = '\0';
    if (size)
        *size = used;
    return bytes;
}

bool base_finish_stdout(void)
{
    errno = 0;
    bool good = fflush(stdout) == 0 && !ferror(stdout);
    /* A reader that has seen enough (head, less) is no failure worth a line. */
    if (!good && errno != EPIPE)
        base_error("cannot write standard output: %s",
                   errno ? strerror(errno) : "an earlier write failed");
    return good;
}
