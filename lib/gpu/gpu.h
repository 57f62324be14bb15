/* gpu.h: headless Vulkan, as little of it as measuring and checking need.
 *
 * A device is opened by name and then owns everything that is made from it; nothing here opens a
 * window. Calls are synchronous. A device and what belongs to it are used by one thread at a
 * time; different devices may be used by different threads.
 *
 * Every function that can fail returns a gpu_status, leaves its outputs untouched (pointers: NULL)
 * and stores one line for people, which gpu_last_error returns. GPU_NO_DEVICE alone means that
 * this machine lacks the driver that was asked for: a test skips then, unless CI is set.
 */
#ifndef GPU_H
#define GPU_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum gpu_status {
    GPU_OK = 0,
    GPU_NO_DEVICE,     /* no Vulkan, or no device of that name, or no validation layer */
    GPU_UNSUPPORTED,   /* the device lacks what was asked for */
    GPU_BAD_SHADER,    /* the source does not compile */
    GPU_OUT_OF_MEMORY, /* of the host or of the device */
    GPU_DEVICE_LOST,
    GPU_FAILED /* anything else that Vulkan reports */
} gpu_status;

const char *gpu_status_string(gpu_status status);

/* One line about the last call of this thread that did not return GPU_OK; "" before that. */
const char *gpu_last_error(void);

/* Stores that line and returns status: for rooms built on this one. */
gpu_status gpu_fail(gpu_status status, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* ---- Devices ------------------------------------------------------------------------------ */

typedef struct gpu_device gpu_device;

typedef struct gpu_device_options {
    /* Part of the device's or driver's name, in any case ("llvmpipe", "radeon"); NULL or "": the
     * first one that is there, hardware before software. */
    const char *device;
    /* Where given, device is ignored: a RADV device that only compiles, for hardware that need not
     * be there ("navi21", "gfx1100", "vega10": Mesa's RADV_FORCE_FAMILY, which is set in the
     * environment of this process during the call). Pipelines and their statistics can be made
     * on it, memory and dispatches cannot. */
    const char *compile_for;
    /* Load the Khronos validation layer and collect its messages. */
    bool validation;
} gpu_device_options;

typedef struct gpu_device_info {
    char name[256];    /* "llvmpipe (LLVM 15.0.6, 256 bits)" */
    char driver[256];  /* "llvmpipe" */
    char version[256]; /* "Mesa 22.3.6 (LLVM 15.0.6)" */
    char api[32];      /* "1.3.230" */
    bool software;     /* a CPU: times are only good as ratios within one run */
    bool compile_only;
    bool statistics;             /* gpu_compute_statistics works */
    bool timestamps;             /* else times are taken around the submission */
    double timestamp_nanosecond; /* length of a tick */
} gpu_device_info;

gpu_status gpu_device_open(const gpu_device_options *options, gpu_device **device);
void gpu_device_close(
    gpu_device *device); /* NULL is fine; all that belongs to it is closed before */
const gpu_device_info *gpu_device_about(const gpu_device *device);

/* Names of the devices that are there, one per line, in text of the given size; the status of the
 * listing. */
gpu_status gpu_device_list(char *text, size_t size);

/* Messages of the validation layer so far, of any severity above information: their number, and
 * the text of the first few, one per line. */
int gpu_message_count(const gpu_device *device);
const char *gpu_messages(const gpu_device *device);

/* ---- Buffers and textures ------------------------------------------------------------------ */

/* Visible to the host all the time: read and write through gpu_buffer_map between dispatches. Any
 * buffer may hold storage, indices and the arguments of indirect steps. Size 0 counts as 4. */
typedef struct gpu_buffer gpu_buffer;

gpu_status gpu_buffer_create(gpu_device *device, size_t size, gpu_buffer **buffer);
void gpu_buffer_destroy(gpu_buffer *buffer); /* NULL is fine */
void *gpu_buffer_map(gpu_buffer *buffer);
size_t gpu_buffer_size(const gpu_buffer *buffer);

/* One or two dimensions, float channels, bilinear, clamped to the edge, one level. */
typedef struct gpu_texture gpu_texture;

typedef struct gpu_texture_options {
    uint32_t width, height; /* height 0: one-dimensional, sampler1D */
    int channels;           /* 1, 2 or 4; 0 counts as 1 */
    bool half;              /* values are rounded to half */
    const float *texels;    /* width * max(height, 1) * channels, row after row */
} gpu_texture_options;

gpu_status gpu_texture_create(gpu_device *device, const gpu_texture_options *options,
                              gpu_texture **texture);
void gpu_texture_destroy(gpu_texture *texture); /* NULL is fine */

/* ---- Compute -------------------------------------------------------------------------------- */

typedef enum gpu_binding {
    GPU_STORAGE_BUFFER, /* a gpu_buffer */
    GPU_SAMPLED,        /* a gpu_texture: combined image and sampler */
    GPU_STORAGE_IMAGE,  /* a gpu_image of pass.h, for imageLoad and imageStore; the shader names its
                           format */
    GPU_FETCHED         /* a gpu_image of pass.h: combined image and sampler, for texelFetch */
} gpu_binding;

enum { GPU_MAX_BINDINGS = 16, GPU_MAX_PUSH = 128 };

typedef struct gpu_compute gpu_compute;

typedef struct gpu_compute_options {
    const char *name;      /* stands for the file name in error lines */
    const char *source;    /* GLSL with its #version line, entry point main */
    const uint32_t *words; /* or SPIR-V with the entry point main, where not NULL */
    size_t word_count;
    int binding_count; /* set 0, bindings 0 to binding_count - 1 */
    gpu_binding bindings[GPU_MAX_BINDINGS];
    uint32_t push_size; /* bytes of push constants, a multiple of 4 */
    float constant;     /* the shader's constant_id 0, a float; 0: as the shader has it */
    bool statistics;    /* keep them for gpu_compute_statistics */
} gpu_compute_options;

/* GPU_BAD_SHADER: gpu_last_error is "NAME:LINE: what is wrong", the first error of possibly more.
 */
gpu_status gpu_compute_create(gpu_device *device, const gpu_compute_options *options,
                              gpu_compute **compute);
/* NULL is fine. A pipeline made of SPIR-V words stays with its device and serves whoever asks for
 * the same again: a software driver takes a second or more to compile it at its first use. */
void gpu_compute_destroy(gpu_compute *compute);

typedef struct gpu_dispatch {
    gpu_compute *compute;
    void *
        resources[GPU_MAX_BINDINGS]; /* gpu_buffer, gpu_texture or gpu_image, as the bindings say */
    uint32_t groups[3];              /* 0 counts as 1 */
    const void *push;                /* push_size bytes */
    int repeat;                      /* the same dispatch several times in one go; 0 counts as 1 */
    double *seconds;                 /* where not NULL: time of all repeats together */
} gpu_dispatch;

/* Runs and waits. What the host wrote is visible to the shader and the other way round. */
gpu_status gpu_dispatch_run(gpu_device *device, const gpu_dispatch *dispatch);

/* ---- What a compiler made of a shader ---------------------------------------------------------
 */

typedef struct gpu_statistics {
    double instructions;
    double inverse_throughput; /* the compiler's estimate of cycles per wave, latency hidden */
    double latency;            /* its estimate of cycles from first to last instruction */
    double vgprs, sgprs;
    double code_size; /* bytes */
    double branches;
} gpu_statistics;

/* As the driver reports them; a figure that it does not report is NaN. */
gpu_status gpu_compute_statistics(const gpu_compute *compute, gpu_statistics *statistics);

typedef enum gpu_stage { GPU_COMPUTE_STAGE, GPU_VERTEX_STAGE, GPU_FRAGMENT_STAGE } gpu_stage;

/* SPIR-V words of a shader, free() them; gpu_compile: of a compute shader. */
gpu_status gpu_compile_stage(gpu_stage stage, const char *name, const char *source,
                             uint32_t **words, size_t *word_count);
gpu_status gpu_compile(const char *name, const char *source, uint32_t **words, size_t *word_count);

/* ---- What a function costs ----------------------------------------------------------------------
 *
 * Everything below takes GLSL that holds a function
 *     float f(float lambda, float cos_theta)
 * and what that needs, without #version. It may declare and use textures at bindings 2 and 3 of
 * set 0. A whole compute shader is made of it, with 64 invocations a group, that reads its
 * arguments from a buffer of floats at binding 0, two for each value, and writes one float for each
 * invocation to binding 1. */
typedef enum gpu_wrapper {
    GPU_ONE,        /* writes f */
    GPU_EIGHT,      /* writes the sum of eight values of f */
    GPU_PIXEL_ONE,  /* the same two with a literal sharpness and the sum of the two floats as  */
    GPU_PIXEL_EIGHT /* cos_theta: the compiler folds away what depends on the sharpness alone, and
                       what is left is done once a pixel where a lobe is prepared once a light */
} gpu_wrapper;

/* The shader as text, free() it; NULL where there is no memory. Line numbers are those of source.
 */
char *gpu_wrap(gpu_wrapper wrapper, const char *source);

/* The function that "empty" stands for below: the sum of its arguments. */
extern const char gpu_empty_function[];

/* empty is GPU_ONE of gpu_empty_function. A slope is (eight - one)/7: what one more evaluation
 * costs, hidden by no memory access; of the empty function it is about one addition. */
typedef struct gpu_cost {
    gpu_statistics one;   /* "one" - "empty", with the addition that only "empty" has put back;
                             inverse throughput and latency: partly hidden by memory */
    gpu_statistics slope; /* one more evaluation */
    gpu_statistics pixel; /* "pixel one" - "empty" */
    gpu_statistics pixel_slope; /* one more evaluation of the part once a pixel */
} gpu_cost;                     /* vgprs and sgprs are always those of the whole shader */

typedef struct gpu_counter gpu_counter;

/* family as in gpu_device_options.compile_for. GPU_NO_DEVICE where RADV is not installed. */
gpu_status gpu_counter_open(const char *family, gpu_counter **counter);
void gpu_counter_close(gpu_counter *counter); /* NULL is fine */
const gpu_device_info *gpu_counter_about(const gpu_counter *counter);
gpu_status gpu_count(gpu_counter *counter, const char *name, const char *source, gpu_cost *cost);

#ifdef __cplusplus
}
#endif

#endif
