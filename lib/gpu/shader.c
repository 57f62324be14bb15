/* GLSL to SPIR-V inside the program. Nothing is optimised here: the driver does that, and what it
 * gets is what another engine's compiler would hand it. */
#include "internal.h"

#include <shaderc/shaderc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <threads.h>

/* One for the whole process, and never released before its end: each one new parses all of GLSL's
 * built-in functions again, which takes longer than our shaders do. It is safe to share. */
static once_flag compiler_once = ONCE_FLAG_INIT;
static shaderc_compiler_t compiler;

static void close_compiler(void)
{
    shaderc_compiler_release(compiler);
}

static void open_compiler(void)
{
    compiler = shaderc_compiler_initialize();
    atexit(close_compiler);
}

/* The first line of the log alone: "NAME:LINE: error: ...". */
static gpu_status report(const char *name, const char *log)
{
    size_t length = strcspn(log, "\n");
    if (length == 0)
        return gpu_fail(GPU_BAD_SHADER, "%s: the shader does not compile", name);
    return gpu_fail(GPU_BAD_SHADER, "%.*s", (int)(length < 900 ? length : 900), log);
}

gpu_status gpu_compile_stage(gpu_stage stage, const char *name, const char *source,
                             uint32_t **words, size_t *word_count)
{
    static const shaderc_shader_kind kinds[] = {shaderc_compute_shader, shaderc_vertex_shader,
                                                shaderc_fragment_shader};
    *words = NULL;
    call_once(&compiler_once, open_compiler);
    shaderc_compile_options_t options = compiler ? shaderc_compile_options_initialize() : NULL;
    if (!options)
        return gpu_fail(GPU_OUT_OF_MEMORY, "%s: out of host memory", name);
    shaderc_compile_options_set_target_env(options, shaderc_target_env_vulkan,
                                           shaderc_env_version_vulkan_1_1);
    shaderc_compile_options_set_optimization_level(options, shaderc_optimization_level_zero);
    shaderc_compilation_result_t result = shaderc_compile_into_spv(
        compiler, source, strlen(source), kinds[stage], name, "main", options);
    gpu_status status = GPU_OK;
    if (shaderc_result_get_compilation_status(result) != shaderc_compilation_status_success) {
        status = report(name, result ? shaderc_result_get_error_message(result) : "");
    } else {
        size_t size = shaderc_result_get_length(result);
        *words = malloc(size);
        if (*words) {
            memcpy(*words, shaderc_result_get_bytes(result), size);
            *word_count = size / sizeof(uint32_t);
        } else {
            status = gpu_fail(GPU_OUT_OF_MEMORY, "%s: out of host memory", name);
        }
    }
    shaderc_result_release(result);
    shaderc_compile_options_release(options);
    return status;
}

gpu_status gpu_compile(const char *name, const char *source, uint32_t **words, size_t *word_count)
{
    return gpu_compile_stage(GPU_COMPUTE_STAGE, name, source, words, word_count);
}

gpu_status gpu_module_create(gpu_device *device, gpu_stage stage, const char *name,
                             const gpu_shader *shader, VkShaderModule *module)
{
    static const uint32_t magic = 0x07230203;
    uint32_t *compiled = NULL;
    const uint32_t *words = shader->words;
    size_t word_count = shader->word_count;
    if (!words) {
        if (!shader->source)
            return gpu_fail(GPU_BAD_SHADER, "%s: no shader given", name);
        gpu_status status = gpu_compile_stage(stage, name, shader->source, &compiled, &word_count);
        if (status != GPU_OK)
            return status;
        words = compiled;
    } else if (word_count < 5 || words[0] != magic) {
        return gpu_fail(GPU_BAD_SHADER, "%s: not SPIR-V", name);
    }
    VkShaderModuleCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                     .codeSize = word_count * sizeof(uint32_t),
                                     .pCode = words};
    VkResult result = vkCreateShaderModule(device->device, &info, NULL, module);
    free(compiled);
    return result == VK_SUCCESS ? GPU_OK : gpu_vk(result, name);
}
