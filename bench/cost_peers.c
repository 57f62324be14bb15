/* cost_peers.c: a published method as its authors ship it.
 *
 * Our helpers are accurate to float everywhere. The authors' shaders have cheaper ones, and it
 * would be unfair to charge them for ours: for counting, their helpers are put in their place. The
 * texts in bench/peers are our own words with the same structure (polynomial degrees, exponentials,
 * logarithms, both sides of a branch), hence of the same cost. Errors are still measured with the
 * accurate helpers. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/text.h"
#include "cost.h"

/* Takes the function of that name out of the text, which is as `sgfit emit` lays it out. */
static void cut_function(char *text, const char *name)
{
    char head[128];
    snprintf(head, sizeof head, "\nfloat %s(", name);
    char *start = strstr(text, head);
    char *end = start ? strstr(start, "\n}\n") : NULL;
    if (end)
        memmove(start, end + 2, strlen(end + 2) + 1);
}

static bool replace(buffer *peers, char *text, const char *folder, const char *file)
{
    char *path = base_join(folder, file);
    char *peer = base_read_file(path, NULL);
    free(path);
    if (!peer)
        return false;
    buffer_add(peers, peer);
    free(peer);
    char *name = base_copy(file, strlen(file) - strlen(".glsl"));
    cut_function(text, name);
    free(name);
    return true;
}

char *cost_as_shipped(const char *glsl)
{
    char **files;
    size_t count;
    char *folder = base_join(base_source_root(), "bench/peers");
    char *ours = base_copy(glsl, strlen(glsl));
    buffer text = {0};
    bool good = base_list(folder, ".glsl", &files, &count);
    if (good) {
        for (size_t i = 0; i < count && good; i++)
            good = replace(&text, ours, folder, files[i]);
        buffer_add(&text, ours);
        base_list_free(files, count);
    }
    if (!good)
        buffer_free(&text);
    free(ours);
    free(folder);
    return text.text;
}
