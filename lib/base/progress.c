#include "progress.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

struct base_progress {
    pthread_mutex_t lock;
    const char *what;
    size_t steps, done;
    double begun, drawn_at;
    bool terminal, drawn;
};

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

base_progress *base_progress_begin(const char *what, size_t steps)
{
    base_progress *progress = calloc(1, sizeof *progress);
    if (!progress)
        return NULL;
    pthread_mutex_init(&progress->lock, NULL);
    progress->what = what;
    progress->steps = steps;
    progress->begun = now();
    progress->terminal = isatty(STDERR_FILENO) != 0;
    return progress;
}

void base_progress_step(base_progress *progress, const char *item)
{
    if (!progress)
        return;
    pthread_mutex_lock(&progress->lock);
    progress->done++;
    double t = now();
    /* Ten lines a second are enough for an eye and cost nothing. */
    if (progress->terminal && t - progress->begun > 1.0 && t - progress->drawn_at > 0.1) {
        fprintf(stderr, "\r\033[K%s %zu/%zu%s%.60s", progress->what, progress->done,
                progress->steps, item ? ": " : "", item ? item : "");
        fflush(stderr);
        progress->drawn = true;
        progress->drawn_at = t;
    }
    pthread_mutex_unlock(&progress->lock);
}

void base_progress_end(base_progress *progress)
{
    if (!progress)
        return;
    if (progress->drawn) {
        fputs("\r\033[K", stderr);
        fflush(stderr);
    }
    pthread_mutex_destroy(&progress->lock);
    free(progress);
}

typedef struct shared_work {
    pthread_mutex_t lock;
    size_t next, count;
    void (*job)(void *context, size_t index);
    void *context;
} shared_work;

static void *work_until_done(void *argument)
{
    shared_work *work = argument;
    for (;;) {
        pthread_mutex_lock(&work->lock);
        size_t index = work->next < work->count ? work->next++ : work->count;
        pthread_mutex_unlock(&work->lock);
        if (index == work->count)
            return NULL;
        work->job(work->context, index);
    }
}

void base_parallel(size_t count, void (*job)(void *context, size_t index), void *context)
{
    enum { MOST_HELPERS = 255 };
    pthread_t helpers[MOST_HELPERS];
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    size_t wanted = cores > 1 ? (size_t)cores - 1 : 0;
    if (wanted > MOST_HELPERS)
        wanted = MOST_HELPERS;
    if (count < 1 || wanted > count - 1)
        wanted = count < 1 ? 0 : count - 1;

    shared_work work = {.count = count, .job = job, .context = context};
    pthread_mutex_init(&work.lock, NULL);
    size_t started = 0;
    /* Where no thread is to be had the caller does all of it. */
    while (started < wanted && pthread_create(&helpers[started], NULL, work_until_done, &work) == 0)
        started++;
    work_until_done(&work);
    for (size_t i = 0; i < started; i++)
        pthread_join(helpers[i], NULL);
    pthread_mutex_destroy(&work.lock);
}
