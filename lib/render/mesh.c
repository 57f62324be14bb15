/* mesh.c: starts the child process that reads a mesh file, waits no longer than the limit, and
 * believes nothing that comes back. */
#include "mesh.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/text.h"
#include "mesh_child.h"
#include "mesh_private.h"

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static bool is_mesh_name(const char *path)
{
    static const char *const endings[] = {".obj", ".ply", ".gltf", ".glb"};
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof endings / sizeof *endings; i++)
        if (strcasecmp(dot, endings[i]) == 0)
            return true;
    return false;
}

static bool check_file(const char *path)
{
    struct stat status;
    if (!is_mesh_name(path)) {
        base_error("%s: expected a mesh file ending in .obj, .ply, .gltf or .glb", path);
        return false;
    }
    if (stat(path, &status) != 0) {
        base_error("cannot read %s: %s", path, strerror(errno));
        return false;
    }
    if (!S_ISREG(status.st_mode) || status.st_size == 0) {
        base_error("%s: expected a mesh file, found %s", path,
                   S_ISREG(status.st_mode) ? "an empty file" : "something else");
        return false;
    }
    return true;
}

static void limit_child(const mesh_limits *limits)
{
    const struct rlimit none = {0, 0};
    setrlimit(RLIMIT_CORE, &none);
#ifndef __SANITIZE_ADDRESS__ /* which reserves terabytes */
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file) {
        if (fscanf(file, "%lu", &pages) != 1)
            pages = 0;
        fclose(file);
    }
    rlim_t most = (rlim_t)limits->memory + (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE);
    const struct rlimit memory = {most, most};
    setrlimit(RLIMIT_AS, &memory);
#endif
    /* Should the parent die first, this one still ends. */
    alarm((unsigned)ceil(limits->seconds) + 1);
}

/* Nothing of the parent's stays open: what the child flushes or prints must not go anywhere. */
static void close_all_but(int pipe)
{
    int nowhere = open("/dev/null", O_RDWR);
    for (int file = 0; file <= 2; file++)
        dup2(nowhere, file);
    int most = 2;
    DIR *folder = opendir("/proc/self/fd");
    for (struct dirent *entry; folder && (entry = readdir(folder)) != NULL;)
        most = atoi(entry->d_name) > most ? atoi(entry->d_name) : most;
    if (folder)
        closedir(folder);
    else
        most = 1024;
    for (int file = 3; file <= most; file++)
        if (file != pipe)
            close(file);
    signal(SIGPIPE, SIG_DFL);
    signal(SIGALRM, SIG_DFL);
}

/* Everything that the child writes until it ends: 1, 0 when the time is over, -1 without memory. */
static int receive(int pipe, double end, char **bytes, size_t *size)
{
    size_t capacity = 0;
    for (;;) {
        double left = end - now();
        struct pollfd waiting = {.fd = pipe, .events = POLLIN};
        if (left <= 0 || poll(&waiting, 1, (int)ceil(left * 1000)) == 0)
            return 0;
        if (*size == capacity) {
            capacity = 2 * capacity + (1 << 16);
            char *more = realloc(*bytes, capacity);
            if (!more)
                return -1;
            *bytes = more;
        }
        ssize_t got = read(pipe, *bytes + *size, capacity - *size);
        if (got == 0)
            return 1;
        if (got > 0)
            *size += (size_t)got;
        else if (errno != EINTR)
            return 1; /* what is missing is found below */
    }
}

/* The child's answer as malloc'ed bytes, NULL after one line. */
static char *ask_child(const char *path, const mesh_limits *limits, size_t *size)
{
    int ends[2];
    char *bytes = NULL;
    *size = 0;
    if (pipe(ends) != 0) {
        base_error("%s: no pipe to a process that reads it: %s", path, strerror(errno));
        return NULL;
    }
    double end = now() + limits->seconds;
    pid_t child = fork();
    if (child == 0) {
        close_all_but(ends[1]);
        limit_child(limits);
        mesh_child(path, ends[1]);
    }
    int reason = errno;
    close(ends[1]);
    int received = child > 0 ? receive(ends[0], end, &bytes, size) : 1;
    close(ends[0]);
    int status = 0;
    if (child > 0) {
        if (received != 1)
            kill(child, SIGKILL);
        while (waitpid(child, &status, 0) < 0 && errno == EINTR)
            ;
    }
    if (child < 0)
        base_error("%s: no process to read it: %s", path, strerror(reason));
    else if (received < 0)
        base_error("%s: out of memory", path);
    else if (received == 0)
        base_error("%s: not read within %g s: the file is damaged or too large", path,
                   limits->seconds);
    else if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        base_error("%s: the process that read it broke off: the file is damaged or too large",
                   path);
    else if (*size < sizeof(mesh_head))
        base_error("%s: the process that read it said nothing", path);
    else
        return bytes;
    free(bytes);
    return NULL;
}

/* The next count values of a size, copied to their own memory; false where there are not as many.
 */
static bool take(const char **next, size_t *left, uint64_t count, size_t size, void *array)
{
    if (count > *left / size)
        return false;
    void *copy = malloc(count ? (size_t)count * size : 1);
    memcpy(array, &copy, sizeof copy);
    if (!copy)
        return false;
    memcpy(copy, *next, (size_t)count * size);
    *next += count * size;
    *left -= (size_t)count * size;
    return true;
}

static bool unpack(const mesh_head *head, const char *next, size_t left, mesh *result)
{
    if (head->magic != MESH_MAGIC || head->vertices > UINT32_MAX || head->triangles > UINT32_MAX ||
        head->materials > UINT32_MAX)
        return false;
    *result = (mesh){.vertex_count = (size_t)head->vertices,
                     .triangle_count = (size_t)head->triangles,
                     .material_count = (size_t)head->materials,
                     .left_out = (size_t)head->left_out};
    if (!take(&next, &left, 3 * head->vertices, sizeof(float), &result->positions) ||
        !take(&next, &left, 3 * head->vertices, sizeof(float), &result->normals) ||
        !take(&next, &left, 3 * head->triangles, sizeof(uint32_t), &result->indices) ||
        !take(&next, &left, head->triangles, sizeof(uint32_t), &result->materials) ||
        !take(&next, &left, 3 * head->materials, sizeof(float), &result->albedos) || left != 0)
        return false;
    for (size_t i = 0; i < 3 * result->triangle_count; i++)
        if (result->indices[i] >= result->vertex_count)
            return false;
    for (size_t i = 0; i < result->triangle_count; i++)
        if (result->materials[i] >= result->material_count)
            return false;
    for (size_t i = 0; i < 3 * result->material_count; i++) {
        float *albedo = &result->albedos[i];
        *albedo = *albedo > 0 ? fminf(*albedo, 1) : 0; /* NaN: 0 */
    }
    return true;
}

bool mesh_read(const char *path, const mesh_limits *limits, mesh *result)
{
    mesh_limits usual = {.seconds = limits && limits->seconds > 0 ? limits->seconds : 60,
                         .memory = limits && limits->memory ? limits->memory : (uint64_t)4 << 30};
    *result = (mesh){0};
    size_t size;
    if (!check_file(path))
        return false;
    char *bytes = ask_child(path, &usual, &size);
    if (!bytes)
        return false;
    mesh_head head;
    memcpy(&head, bytes, sizeof head);
    const char *rest = bytes + sizeof head;
    size_t left = size - sizeof head;
    bool good = false;
    if (head.magic == MESH_MAGIC && head.failed)
        base_error("%s: expected a mesh, found a damaged file: %.*s", path, (int)left, rest);
    else if (!(good = unpack(&head, rest, left, result)))
        base_error("%s: expected a mesh, found indices or counts that do not fit together", path);
    else
        good = mesh_read_materials(path, result);
    free(bytes);
    if (!good)
        mesh_free(result);
    return good;
}

void mesh_free(mesh *result)
{
    free(result->positions);
    free(result->normals);
    free(result->indices);
    free(result->materials);
    free(result->albedos);
    *result = (mesh){0};
}
