#include "internal.h"

#include <stdarg.h>
#include <stdio.h>

static _Thread_local char last_error[1024];

const char *gpu_last_error(void)
{
    return last_error;
}

gpu_status gpu_fail(gpu_status status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(last_error, sizeof last_error, format, arguments);
    va_end(arguments);
    return status;
}

const char *gpu_status_string(gpu_status status)
{
    switch (status) {
    case GPU_OK:
        return "ok";
    case GPU_NO_DEVICE:
        return "no such Vulkan device";
    case GPU_UNSUPPORTED:
        return "not supported by the device";
    case GPU_BAD_SHADER:
        return "the shader does not compile";
    case GPU_OUT_OF_MEMORY:
        return "out of memory";
    case GPU_DEVICE_LOST:
        return "the device was lost";
    case GPU_FAILED:
        return "Vulkan reported an error";
    }
    return "unknown status";
}

gpu_status gpu_vk(VkResult result, const char *what)
{
    switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return gpu_fail(GPU_OUT_OF_MEMORY, "%s: out of host memory", what);
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return gpu_fail(GPU_OUT_OF_MEMORY, "%s: out of device memory", what);
    case VK_ERROR_OUT_OF_POOL_MEMORY:
    case VK_ERROR_FRAGMENTED_POOL:
        return gpu_fail(GPU_OUT_OF_MEMORY, "%s: out of descriptor memory", what);
    case VK_ERROR_DEVICE_LOST:
        return gpu_fail(GPU_DEVICE_LOST, "%s: the device was lost", what);
    case VK_ERROR_INCOMPATIBLE_DRIVER:
        return gpu_fail(GPU_NO_DEVICE, "%s: no Vulkan driver is installed", what);
    case VK_ERROR_LAYER_NOT_PRESENT:
        return gpu_fail(GPU_NO_DEVICE, "%s: the Khronos validation layer is not installed", what);
    case VK_ERROR_EXTENSION_NOT_PRESENT:
    case VK_ERROR_FEATURE_NOT_PRESENT:
    case VK_ERROR_FORMAT_NOT_SUPPORTED:
        return gpu_fail(GPU_UNSUPPORTED, "%s: not supported by the device", what);
    default:
        return gpu_fail(GPU_FAILED, "%s: Vulkan error %d", what, (int)result);
    }
}
