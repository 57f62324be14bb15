/* Pipelines of built-in shaders are kept as long as their device: a software driver compiles a
 * shader at its first use, for a second or more, and an application makes the same ones for every
 * frame that it sets up. */
#include "internal.h"

#include <stdlib.h>
#include <string.h>

struct gpu_kept {
    gpu_kept *next;
    gpu_compute *compute; /* one of the two */
    gpu_draw *draw;
    size_t key_size;
    unsigned char key[];
};

/* A key grows by parts; key NULL only measures. */
static void add(unsigned char *key, size_t *size, const void *part, size_t part_size)
{
    if (key)
        memcpy(key + *size, part, part_size);
    *size += part_size;
}

static size_t compute_key(const gpu_compute_options *options, unsigned char *key)
{
    size_t size = 0;
    add(key, &size, "compute", 8);
    add(key, &size, &options->binding_count, sizeof options->binding_count);
    add(key, &size, options->bindings,
        (size_t)options->binding_count * sizeof options->bindings[0]);
    add(key, &size, &options->push_size, sizeof options->push_size);
    add(key, &size, &options->constant, sizeof options->constant);
    add(key, &size, options->words, options->word_count * sizeof *options->words);
    return size;
}

static size_t draw_key(const gpu_draw_options *options, unsigned char *key)
{
    const gpu_shader *vertex = &options->vertex, *fragment = &options->fragment;
    size_t size = 0;
    add(key, &size, options->depth ? "draw  d" : "draw   ", 8);
    add(key, &size, options->lines ? "lines " : "faces ", 6);
    add(key, &size, &options->binding_count, sizeof options->binding_count);
    add(key, &size, options->bindings,
        (size_t)options->binding_count * sizeof options->bindings[0]);
    add(key, &size, &options->push_size, sizeof options->push_size);
    add(key, &size, &options->constant, sizeof options->constant);
    add(key, &size, &options->target_count, sizeof options->target_count);
    add(key, &size, options->targets, (size_t)options->target_count * sizeof options->targets[0]);
    add(key, &size, &vertex->word_count, sizeof vertex->word_count);
    add(key, &size, vertex->words, vertex->word_count * sizeof *vertex->words);
    add(key, &size, fragment->words, fragment->word_count * sizeof *fragment->words);
    return size;
}

/* A new entry with its key, not yet in the list; NULL where there is no memory. */
static gpu_kept *make(size_t size)
{
    gpu_kept *entry = calloc(1, sizeof *entry + size);
    if (entry)
        entry->key_size = size;
    return entry;
}

/* Of the device, with the same key; NULL: none. */
static const gpu_kept *find(const gpu_device *device, const gpu_kept *like)
{
    for (const gpu_kept *kept = device->kept; kept; kept = kept->next)
        if (kept->key_size == like->key_size && memcmp(kept->key, like->key, like->key_size) == 0)
            return kept;
    return NULL;
}

gpu_kept *gpu_kept_compute(gpu_device *device, const gpu_compute_options *options,
                           gpu_compute **compute)
{
    if (!options->words || options->statistics || device->info.compile_only)
        return NULL;
    gpu_kept *entry = make(compute_key(options, NULL));
    if (!entry)
        return NULL;
    compute_key(options, entry->key);
    const gpu_kept *kept = find(device, entry);
    if (!kept)
        return entry;
    *compute = kept->compute;
    free(entry);
    return NULL;
}

gpu_kept *gpu_kept_draw(gpu_device *device, const gpu_draw_options *options, gpu_draw **draw)
{
    if (!options->vertex.words || !options->fragment.words)
        return NULL;
    gpu_kept *entry = make(draw_key(options, NULL));
    if (!entry)
        return NULL;
    draw_key(options, entry->key);
    const gpu_kept *kept = find(device, entry);
    if (!kept)
        return entry;
    *draw = kept->draw;
    free(entry);
    return NULL;
}

void gpu_keep(gpu_device *device, gpu_kept *entry, gpu_compute *compute, gpu_draw *draw)
{
    if (!entry)
        return;
    entry->compute = compute;
    entry->draw = draw;
    if (compute)
        compute->kept = true;
    if (draw)
        draw->kept = true;
    entry->next = device->kept;
    device->kept = entry;
}

void gpu_keep_no_more(gpu_device *device)
{
    while (device->kept) {
        gpu_kept *entry = device->kept;
        device->kept = entry->next;
        if (entry->compute)
            entry->compute->kept = false;
        if (entry->draw)
            entry->draw->kept = false;
        gpu_compute_destroy(entry->compute);
        gpu_draw_destroy(entry->draw);
        free(entry);
    }
}
