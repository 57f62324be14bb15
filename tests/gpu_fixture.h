/* gpu_fixture.h: the software device of the tests. A missing driver skips on a user's machine and
 * fails where CI is set. */
#ifndef GPU_FIXTURE_H
#define GPU_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>

#include "gpu.h"

static inline void skip_or_fail(void)
{
    if (getenv("CI"))
        fail_msg("%s", gpu_last_error());
    fprintf(stderr, "skipped: %s\n", gpu_last_error());
    skip();
}

/* With the validation layer; skips or fails where it is not there. */
static inline gpu_device *open_software_device(void)
{
    gpu_device *device = NULL;
    gpu_status status =
        gpu_device_open(&(gpu_device_options){.device = "llvmpipe", .validation = true}, &device);
    if (status == GPU_NO_DEVICE)
        skip_or_fail();
    if (status != GPU_OK)
        fail_msg("%s", gpu_last_error());
    return device;
}

/* Any message of the validation layer fails the test. */
static inline void close_clean(gpu_device *device)
{
    if (gpu_message_count(device) != 0)
        fail_msg("validation: %s", gpu_messages(device));
    gpu_device_close(device);
}

#endif
