#define _POSIX_C_SOURCE 200809L
#include "machine.h"

#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

#include "sg.h"

void machine_processor(char *text, size_t size)
{
    snprintf(text, size, "unknown");
    FILE *file = fopen("/proc/cpuinfo", "r");
    if (!file)
        return;
    char line[256];
    while (fgets(line, sizeof line, file)) {
        char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) != 0 || !colon || strlen(colon) < 3)
            continue;
        colon[strcspn(colon, "\n")] = '\0';
        snprintf(text, size, "%s", colon + 2);
        break;
    }
    fclose(file);
}

void machine_add_json(cJSON *object)
{
    char text[256];
    struct utsname system = {0};
    uname(&system);
    machine_processor(text, sizeof text);
    cJSON_AddStringToObject(object, "processor", text);
    cJSON_AddNumberToObject(object, "cores", (double)sysconf(_SC_NPROCESSORS_ONLN));
    snprintf(text, sizeof text, "%s %s", system.sysname, system.machine);
    cJSON_AddStringToObject(object, "system", text);
#if defined(__clang__)
    cJSON_AddStringToObject(object, "compiler", __VERSION__);
#else
    cJSON_AddStringToObject(object, "compiler", "GCC " __VERSION__);
#endif
#ifdef __GLIBC__
    snprintf(text, sizeof text, "glibc %s", gnu_get_libc_version());
    cJSON_AddStringToObject(object, "libm", text);
#endif
    cJSON_AddStringToObject(object, "sgfit", SG_VERSION);
}
