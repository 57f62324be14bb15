#include "file.h"

#include "text.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *source_root = SGFIT_SOURCE_ROOT;

const char *base_source_root(void)
{
    return source_root;
}

void base_set_source_root(const char *path)
{
    source_root = path;
}

char *base_join(const char *folder, const char *name)
{
    size_t length = strlen(folder);
    const char *slash = length > 0 && folder[length - 1] == '/' ? "" : "/";
    size_t size = length + strlen(name) + 2;
    char *path = malloc(size);
    if (path)
        snprintf(path, size, "%s%s%s", folder, slash, name);
    return path;
}

static bool is_directory(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

/* The path without links or dots, malloc'ed; NULL where there is no such folder. */
static char *place_of(const char *path)
{
    char *whole = realpath(path, NULL);
    if (whole)
        return whole;
    const char *slash = strrchr(path, '/');
    char *folder = slash ? strndup(path, (size_t)(slash - path) + 1) : strdup(".");
    char *real = folder ? realpath(folder, NULL) : NULL;
    char *place = real ? base_join(real, slash ? slash + 1 : path) : NULL;
    free(real);
    free(folder);
    return place;
}

bool base_same_file(const char *a, const char *b)
{
    struct stat status;
    if (stat(a, &status) == 0 && !S_ISREG(status.st_mode))
        return false;
    char *first = place_of(a), *second = place_of(b);
    bool same = first && second && strcmp(first, second) == 0;
    free(first);
    free(second);
    return same;
}

bool base_make_directory(const char *path)
{
    char *partial = strdup(path);
    if (!partial)
        return false;
    int reason = *path ? 0 : ENOENT;
    for (char *p = partial; !reason; p++) {
        if (*p != '/' && *p != '\0')
            continue;
        bool last = *p == '\0';
        *p = '\0';
        if (p > partial && mkdir(partial, 0777) != 0 && !is_directory(partial))
            reason = errno == EEXIST ? ENOTDIR : errno;
        if (last)
            break;
        *p = '/';
    }
    free(partial);
    if (reason)
        base_error("cannot create directory %s: %s", path, strerror(reason));
    return reason == 0;
}

/* Cuts the last name off a path: "a/b" becomes "a/", "a" "."; false where there is none above. */
static bool cut_name(char *path)
{
    size_t length = strlen(path);
    if (strcmp(path, ".") == 0 || strcmp(path, "/") == 0)
        return false;
    while (length > 1 && path[length - 1] == '/')
        length--;
    while (length > 0 && path[length - 1] != '/')
        length--;
    if (length == 0)
        path[length++] = '.';
    path[length] = '\0';
    return true;
}

bool base_can_fill(const char *folder)
{
    size_t size = strlen(folder) + 2;
    char *there = malloc(size);
    if (!there)
        return false;
    snprintf(there, size, "%s", folder);
    struct stat status;
    int reason = *folder ? 0 : ENOENT;
    /* What is not there yet is made in the first folder above it that is. */
    while (!reason && stat(there, &status) != 0) {
        bool dangling = lstat(there, &status) == 0;
        reason = dangling ? ENOTDIR : errno == ENOENT && cut_name(there) ? 0 : errno;
    }
    if (!reason && !S_ISDIR(status.st_mode))
        reason = ENOTDIR;
    if (!reason && access(there, W_OK | X_OK) != 0)
        reason = errno;
    free(there);
    if (reason)
        base_error("cannot write into %s: %s", folder, strerror(reason));
    return reason == 0;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static bool ends_in(const char *name, const char *suffix)
{
    size_t length = strlen(name), tail = strlen(suffix);
    return length >= tail && strcmp(name + length - tail, suffix) == 0;
}

bool base_list(const char *folder, const char *suffix, char ***names, size_t *count)
{
    *names = NULL;
    *count = 0;
    DIR *directory = opendir(folder);
    if (!directory) {
        base_error("cannot read directory %s: %s", folder, strerror(errno));
        return false;
    }
    int reason = 0;
    size_t capacity = 0;
    for (;;) {
        errno = 0;
        struct dirent *entry = readdir(directory);
        if (!entry) {
            reason = errno;
            break;
        }
        /* Hidden files are editors' business, and unfinished output ends in .part. */
        if (entry->d_name[0] == '.' || !ends_in(entry->d_name, suffix))
            continue;
        if (*count == capacity) {
            capacity = capacity ? 2 * capacity : 32;
            char **grown = realloc(*names, capacity * sizeof **names);
            if (!grown) {
                reason = ENOMEM;
                break;
            }
            *names = grown;
        }
        if (!((*names)[*count] = strdup(entry->d_name))) {
            reason = ENOMEM;
            break;
        }
        ++*count;
    }
    closedir(directory);
    if (reason) {
        base_list_free(*names, *count);
        *names = NULL;
        *count = 0;
        base_error("cannot read directory %s: %s", folder, strerror(reason));
        return false;
    }
    if (*count > 1)
        qsort(*names, *count, sizeof **names, compare_names);
    return true;
}

void base_list_free(char **names, size_t count)
{
    for (size_t i = 0; i < count; i++)
        free(names[i]);
    free(names);
}
