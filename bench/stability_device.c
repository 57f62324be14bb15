/* stability_device.c: the functions of shaders/sg.glsl on a Vulkan device, as subjects of the
 * scan. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"
#include "stability_private.h"

#ifdef HAVE_VULKAN

#include "gpu.h"

enum { CAPACITY = 1 << 17, GROUP = 64 };

struct stability_device {
    gpu_device *gpu;
    gpu_buffer *in, *out; /* pairs of float */
    gpu_compute *compute;
    char *include;
    char name[600];
    const sg_method *method;
};

static char *include_text(void)
{
    char *path = base_join(base_source_root(), "shaders/sg.glsl");
    char *text = base_read_file(path, NULL);
    free(path);
    return text;
}

stability_device *stability_device_open(const char *name, char reason[256])
{
    stability_device *device = calloc(1, sizeof *device);
    if (!device)
        abort();
    device->include = include_text();
    if (!device->include)
        snprintf(reason, 256, "shaders/sg.glsl cannot be read");
    else if (gpu_device_open(&(gpu_device_options){.device = name}, &device->gpu) != GPU_OK ||
             gpu_buffer_create(device->gpu, CAPACITY * 2 * sizeof(float), &device->in) != GPU_OK ||
             gpu_buffer_create(device->gpu, CAPACITY * 2 * sizeof(float), &device->out) != GPU_OK)
        snprintf(reason, 256, "%s", gpu_last_error());
    else {
        const gpu_device_info *about = gpu_device_about(device->gpu);
        snprintf(device->name, sizeof device->name, "%s, %s", about->name, about->version);
        return device;
    }
    stability_device_close(device);
    return NULL;
}

void stability_device_forget(stability_device *device)
{
    gpu_compute_destroy(device->compute);
    device->compute = NULL;
}

void stability_device_close(stability_device *device)
{
    if (!device)
        return;
    stability_device_forget(device);
    gpu_buffer_destroy(device->in);
    gpu_buffer_destroy(device->out);
    gpu_device_close(device->gpu);
    free(device->include);
    free(device);
}

const char *stability_device_name(const stability_device *device)
{
    return device->name;
}

static bool compile(stability_device *device, const sg_method *method)
{
    static const char format[] =
        "#version 450\n"
        "layout(local_size_x = 64) in;\n"
        "layout(std430, binding = 0) readonly buffer A { vec2 a[]; };\n"
        "layout(std430, binding = 1) writeonly buffer B { vec2 b[]; };\n"
        "%s\n"
        "void main()\n"
        "{\n"
        "    vec2 p = a[gl_GlobalInvocationID.x];\n"
        "    b[gl_GlobalInvocationID.x] = vec2(sg_L_%s(p.x, p.y), sg_A_h_%s(p.x, p.y));\n"
        "}\n";
    size_t size = sizeof format + strlen(device->include) + 2 * strlen(method->id);
    char *source = stability_allocate(size);
    snprintf(source, size, format, device->include, method->id, method->id);
    gpu_compute_options options = {.name = method->id, .source = source, .binding_count = 2};
    gpu_status status = gpu_compute_create(device->gpu, &options, &device->compute);
    free(source);
    if (status != GPU_OK)
        base_error("shaders/sg.glsl: %s", gpu_last_error());
    return status == GPU_OK;
}

/* component 0: L, 1: A_h */
static bool run(const stability_subject *subject, size_t n, const double *lambda,
                const double *cos_theta, double *values, size_t component)
{
    const stability_device *device = subject->context;
    float *in = gpu_buffer_map(device->in);
    const float *out = gpu_buffer_map(device->out);
    for (size_t first = 0; first < n; first += CAPACITY) {
        size_t count = n - first < CAPACITY ? n - first : CAPACITY;
        for (size_t i = 0; i < count; i++) {
            in[2 * i] = (float)lambda[first + i];
            in[2 * i + 1] = (float)cos_theta[first + i];
        }
        gpu_dispatch dispatch = {.compute = device->compute,
                                 .resources = {device->in, device->out},
                                 .groups = {(uint32_t)((count + GROUP - 1) / GROUP)}};
        if (gpu_dispatch_run(device->gpu, &dispatch) != GPU_OK) {
            base_error("%s", gpu_last_error());
            return false;
        }
        for (size_t i = 0; i < count; i++)
            values[first + i] = (double)out[2 * i + component];
    }
    return true;
}

static bool device_L(const stability_subject *subject, size_t n, const double *lambda,
                     const double *cos_theta, double *out)
{
    return run(subject, n, lambda, cos_theta, out, 0);
}

static bool device_A_h(const stability_subject *subject, size_t n, const double *lambda,
                       const double *cos_theta, double *out)
{
    return run(subject, n, lambda, cos_theta, out, 1);
}

static bool device_twin(const stability_subject *subject, size_t n, const double *lambda,
                        const double *cos_theta, double *out)
{
    const stability_device *device = subject->context;
    for (size_t i = 0; i < n; i++)
        out[i] = device->method->L_f64(lambda[i], cos_theta[i]);
    return true;
}

bool stability_device_subject(stability_device *device, const sg_method *method,
                              stability_subject *subject)
{
    *subject = (stability_subject){.id = method->id,
                                   .precision = STABILITY_DEVICE,
                                   .value = device_L,
                                   .A_h = device_A_h,
                                   .twin = device_twin,
                                   .context = device,
                                   .device = true};
    device->method = method;
    return compile(device, method);
}

#else

stability_device *stability_device_open(const char *name, char reason[256])
{
    snprintf(reason, 256, "%s: built without Vulkan and shaderc", name);
    return NULL;
}

void stability_device_forget(stability_device *device)
{
    (void)device;
}

void stability_device_close(stability_device *device)
{
    (void)device;
}

const char *stability_device_name(const stability_device *device)
{
    (void)device;
    return "";
}

bool stability_device_subject(stability_device *device, const sg_method *method,
                              stability_subject *subject)
{
    (void)device;
    (void)method;
    (void)subject;
    return false;
}

#endif
