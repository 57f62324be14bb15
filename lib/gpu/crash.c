/* One line where the driver crashes because memory ran out. */
#include "internal.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static char line[160];

static void tell(int number)
{
    (void)number;
    if (write(STDERR_FILENO, line, strlen(line)) < 0)
        _exit(2);
    _exit(1);
}

/* Software drivers, and LLVM below them, do not look whether they were given memory. Without a
 * limit they always are, and a crash is a crash. */
void gpu_tell_of_crashes(void)
{
    static const int crashes[] = {SIGSEGV, SIGBUS, SIGABRT};
    struct rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return;
    snprintf(line, sizeof line,
             "sgfit: the Vulkan driver crashed, most likely out of memory: the address space is "
             "limited to %llu MB (ulimit -v)\n",
             (unsigned long long)(limit.rlim_cur >> 20));
    for (size_t i = 0; i < sizeof crashes / sizeof *crashes; i++) {
        struct sigaction action;
        if (sigaction(crashes[i], NULL, &action) != 0 || action.sa_handler != SIG_DFL)
            continue; /* somebody else's, such as a sanitizer's */
        action.sa_handler = tell;
        sigaction(crashes[i], &action, NULL);
    }
}
