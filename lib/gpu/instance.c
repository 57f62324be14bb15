/* The instance, what the validation layer says, and the devices that are there. */
#include "internal.h"

#include <stdio.h>
#include <string.h>

#ifdef __SANITIZE_ADDRESS__
/* Drivers keep what they allocate once and for all in variables of their own. The loader unloads
 * them with the last instance, and then a leak checker finds nobody who points there: under it they
 * stay loaded. The loader calls this one in place of the C library's. */
int dlclose(void *library);
int dlclose(void *library)
{
    (void)library;
    return 0;
}
#endif

static VKAPI_ATTR VkBool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                              VkDebugUtilsMessageTypeFlagsEXT type,
                                              const VkDebugUtilsMessengerCallbackDataEXT *data,
                                              void *context)
{
    (void)severity;
    (void)type;
    gpu_device *device = context;
    device->message_count++;
    size_t used = strlen(device->messages);
    snprintf(device->messages + used, sizeof device->messages - used, "%s\n", data->pMessage);
    return VK_FALSE;
}

static VkDebugUtilsMessengerCreateInfoEXT messenger_info(gpu_device *device)
{
    /* Not the general type: the loader talks about its own search for drivers there. */
    return (VkDebugUtilsMessengerCreateInfoEXT){
        .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
        .messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                           VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
        .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                       VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT,
        .pfnUserCallback = collect,
        .pUserData = device,
    };
}

gpu_status gpu_create_instance(gpu_device *device, bool validation)
{
    VkApplicationInfo application = {
        .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
        .pApplicationName = "sgfit",
        .apiVersion = VK_API_VERSION_1_3,
    };
    const char *layers[] = {"VK_LAYER_KHRONOS_validation"};
    const char *extensions[] = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME};
    VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info(device);
    VkInstanceCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
        .pNext = validation ? &messenger : NULL,
        .pApplicationInfo = &application,
        .enabledLayerCount = validation ? 1 : 0,
        .ppEnabledLayerNames = layers,
        .enabledExtensionCount = validation ? 1 : 0,
        .ppEnabledExtensionNames = extensions,
    };
    VkResult result = vkCreateInstance(&info, NULL, &device->instance);
    if (result != VK_SUCCESS)
        return gpu_vk(result, "opening Vulkan");
    if (!validation)
        return GPU_OK;
    PFN_vkCreateDebugUtilsMessengerEXT create = (PFN_vkCreateDebugUtilsMessengerEXT)(void (*)(
        void))vkGetInstanceProcAddr(device->instance, "vkCreateDebugUtilsMessengerEXT");
    if (!create)
        return gpu_fail(GPU_NO_DEVICE, "opening Vulkan: no debug messenger");
    result = create(device->instance, &messenger, NULL, &device->messenger);
    return result == VK_SUCCESS ? GPU_OK : gpu_vk(result, "opening Vulkan");
}

void gpu_destroy_instance(gpu_device *device)
{
    if (device->messenger) {
        PFN_vkDestroyDebugUtilsMessengerEXT destroy =
            (PFN_vkDestroyDebugUtilsMessengerEXT)(void (*)(void))vkGetInstanceProcAddr(
                device->instance, "vkDestroyDebugUtilsMessengerEXT");
        if (destroy)
            destroy(device->instance, device->messenger, NULL);
    }
    if (device->instance)
        vkDestroyInstance(device->instance, NULL);
}

void gpu_describe(VkPhysicalDevice physical, VkPhysicalDeviceProperties2 *properties,
                  VkPhysicalDeviceDriverProperties *driver)
{
    *driver = (VkPhysicalDeviceDriverProperties){
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    *properties = (VkPhysicalDeviceProperties2){
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = driver};
    vkGetPhysicalDeviceProperties2(physical, properties);
}

gpu_status gpu_enumerate(VkInstance instance, VkPhysicalDevice devices[GPU_MAX_DEVICES],
                         uint32_t *count)
{
    *count = GPU_MAX_DEVICES;
    VkResult result = vkEnumeratePhysicalDevices(instance, count, devices);
    if (result == VK_SUCCESS || result == VK_INCOMPLETE)
        return GPU_OK;
    /* The loader says this where every driver it found declined. */
    if (result == VK_ERROR_INITIALIZATION_FAILED) {
        *count = 0;
        return GPU_OK;
    }
    return gpu_vk(result, "listing Vulkan devices");
}

int gpu_message_count(const gpu_device *device)
{
    return device->message_count;
}

const char *gpu_messages(const gpu_device *device)
{
    return device->messages;
}

gpu_status gpu_device_list(char *text, size_t size)
{
    text[0] = 0;
    gpu_device scratch = {0};
    gpu_status status = gpu_create_instance(&scratch, false);
    if (status != GPU_OK)
        return status;
    VkPhysicalDevice devices[GPU_MAX_DEVICES];
    uint32_t count = 0;
    status = gpu_enumerate(scratch.instance, devices, &count);
    for (uint32_t i = 0; i < count; i++) {
        VkPhysicalDeviceProperties2 properties;
        VkPhysicalDeviceDriverProperties driver;
        gpu_describe(devices[i], &properties, &driver);
        size_t used = strlen(text);
        snprintf(text + used, size - used, "%s, %s %s\n", properties.properties.deviceName,
                 driver.driverName, driver.driverInfo);
    }
    gpu_destroy_instance(&scratch);
    return status;
}
