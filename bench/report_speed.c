/* report_speed.c: see report_speed.h. */
#define _POSIX_C_SOURCE 200809L
#include "report_speed.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

#include "sg.h"

#ifdef HAVE_VULKAN
#include "gpu.h"
#endif

enum { POINTS = 4096, REPEATS = 41 };

/* Where single values go, so that a value that nobody reads is computed. */
static volatile double single;

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

report_speeds report_speed(void)
{
    static report_speeds speeds;
    static double lambda[POINTS], beta[POINTS], batch[POINTS];
    if (speeds.single > 0.0)
        return speeds;
    /* A fixed sequence that visits both ranges evenly (two irrational steps). */
    for (int i = 0; i < POINTS; i++) {
        lambda[i] = pow(10.0, 7.0 * fmod(i * 0.7548776662466927, 1.0) - 3.0);
        beta[i] = 3.141592653589793 * fmod(i * 0.5698402909980532, 1.0);
    }
    double best[2] = {1e30, 1e30};
    for (int r = 0; r < REPEATS; r++) {
        double begin = seconds();
        for (int i = 0; i < POINTS; i++)
            single = sg_A_h(lambda[i], beta[i]);
        double middle = seconds();
        sg_A_h_batch(POINTS, lambda, beta, batch);
        double end = seconds();
        best[0] = fmin(best[0], middle - begin);
        best[1] = fmin(best[1], end - middle);
    }
    speeds = (report_speeds){POINTS / best[0], POINTS / best[1]};
    return speeds;
}

void report_driver(char *text, size_t size)
{
#ifdef HAVE_VULKAN
    gpu_device *device = NULL;
    gpu_device_options options = {0};
    if (gpu_device_open(&options, &device) == GPU_OK) {
        const gpu_device_info *info = gpu_device_about(device);
        snprintf(text, size, "%s, %s", info->name, info->version);
        gpu_device_close(device);
    } else
        snprintf(text, size, "none (%s)", gpu_last_error());
#else
    snprintf(text, size, "built without Vulkan");
#endif
}
