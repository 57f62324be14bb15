/* Choosing and opening a device. */
#include "internal.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static bool contains(const char *text, const char *part)
{
    size_t length = strlen(part);
    for (; *text; text++) {
        size_t i = 0;
        while (i < length && text[i] &&
               tolower((unsigned char)text[i]) == tolower((unsigned char)part[i]))
            i++;
        if (i == length)
            return true;
    }
    return length == 0;
}

/* Smaller is better; -1 where it is not what was asked for. */
static int rank(const gpu_device_options *options, const VkPhysicalDeviceProperties *properties,
                const VkPhysicalDeviceDriverProperties *driver)
{
    if (options->compile_for)
        return driver->driverID == VK_DRIVER_ID_MESA_RADV ? 0 : -1;
    if (options->device && !contains(properties->deviceName, options->device) &&
        !contains(driver->driverName, options->device))
        return -1;
    switch (properties->deviceType) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return 1;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return 3;
    default:
        return 2;
    }
}

static gpu_status choose_device(gpu_device *device, const gpu_device_options *options)
{
    VkPhysicalDevice devices[GPU_MAX_DEVICES];
    uint32_t count;
    gpu_status status = gpu_enumerate(device->instance, devices, &count);
    if (status != GPU_OK)
        return status;
    int best = -1;
    for (uint32_t i = 0; i < count; i++) {
        VkPhysicalDeviceProperties2 properties;
        VkPhysicalDeviceDriverProperties driver;
        gpu_describe(devices[i], &properties, &driver);
        int r = rank(options, &properties.properties, &driver);
        if (r < 0 || (best >= 0 && r >= best))
            continue;
        best = r;
        device->physical = devices[i];
        gpu_device_info *info = &device->info;
        uint32_t api = properties.properties.apiVersion;
        snprintf(info->name, sizeof info->name, "%s", properties.properties.deviceName);
        snprintf(info->driver, sizeof info->driver, "%s", driver.driverName);
        snprintf(info->version, sizeof info->version, "%s", driver.driverInfo);
        snprintf(info->api, sizeof info->api, "%u.%u.%u", VK_API_VERSION_MAJOR(api),
                 VK_API_VERSION_MINOR(api), VK_API_VERSION_PATCH(api));
        device->limits = properties.properties.limits;
        info->software = properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
        info->compile_only = options->compile_for != NULL;
        info->timestamp_nanosecond = (double)properties.properties.limits.timestampPeriod;
    }
    if (best >= 0)
        return GPU_OK;
    return gpu_fail(GPU_NO_DEVICE, "no Vulkan device whose name contains '%s'",
                    options->device ? options->device : "");
}

static gpu_status open_device(gpu_device *device, const gpu_device_options *options)
{
    gpu_status status = gpu_create_instance(device, options->validation);
    if (status == GPU_OK)
        status = choose_device(device, options);
    if (status == GPU_OK)
        status = gpu_create_device(device);
    return status;
}

/* A driver that does not know the family aborts the process, and names differ between versions of
 * Mesa: a child tries first, and its death is the answer. */
static bool family_is_known(const gpu_device_options *options)
{
    pid_t child = fork();
    if (child == 0) {
        setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
        int nowhere = open("/dev/null", O_WRONLY);
        if (nowhere >= 0)
            dup2(nowhere, STDERR_FILENO);
        gpu_device device = {0};
        gpu_status status = gpu_create_instance(&device, false);
        if (status == GPU_OK)
            status = choose_device(&device, options);
        _exit(status == GPU_OK ? 0 : 1);
    }
    int end = 1;
    while (child > 0 && waitpid(child, &end, 0) < 0 && errno == EINTR)
        continue;
    return child > 0 && WIFEXITED(end) && WEXITSTATUS(end) == 0;
}

/* Sets a variable of the environment and returns what it was (malloc'ed, or NULL). */
static char *swap_environment(const char *name, const char *value)
{
    const char *old = getenv(name);
    char *copy = old ? strdup(old) : NULL;
    if (value)
        setenv(name, value, 1);
    else
        unsetenv(name);
    return copy;
}

gpu_status gpu_device_open(const gpu_device_options *options, gpu_device **out)
{
    static const gpu_device_options defaults;
    if (!options)
        options = &defaults;
    *out = NULL;
    gpu_device *device = calloc(1, sizeof *device);
    if (!device)
        return gpu_fail(GPU_OUT_OF_MEMORY, "opening Vulkan: out of host memory");
    gpu_tell_of_crashes();
    /* Some drivers print a warning where this is missing. */
    setenv("XDG_RUNTIME_DIR", "/tmp", 0);
    /* Statistics come from compiling, not from somebody's cache. */
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
    char *family = swap_environment("RADV_FORCE_FAMILY", options->compile_for);
    gpu_status status = GPU_OK;
    if (options->compile_for && !family_is_known(options))
        status =
            gpu_fail(GPU_NO_DEVICE, "no RADV driver that compiles for '%s'", options->compile_for);
    if (status == GPU_OK)
        status = open_device(device, options);
    free(swap_environment("RADV_FORCE_FAMILY", family));
    free(family);
    if (status != GPU_OK) {
        gpu_device_close(device);
        return status;
    }
    *out = device;
    return GPU_OK;
}

void gpu_device_close(gpu_device *device)
{
    if (!device)
        return;
    gpu_keep_no_more(device);
    if (device->device) {
        vkDestroySampler(device->device, device->nearest, NULL);
        vkDestroyQueryPool(device->device, device->queries, NULL);
        vkDestroyFence(device->device, device->fence, NULL);
        vkDestroyCommandPool(device->device, device->commands, NULL);
        vkDestroyDevice(device->device, NULL);
    }
    gpu_destroy_instance(device);
    free(device);
}

const gpu_device_info *gpu_device_about(const gpu_device *device)
{
    return &device->info;
}
