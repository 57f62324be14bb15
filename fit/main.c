/* The program: finds the command among those that the rooms export and runs it. */
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/file.h"
#include "base/options.h"
#include "base/text.h"
#include "bench/bench.h"
#include "bench/profile_fit.h"
#include "fit/fit.h"
#include "render/commands.h"
#include "sg.h"
#include "tables/tables.h"

static const base_command *const rooms[] = {fit_commands, tables_commands, bench_commands,
                                            render_commands};
enum { ROOMS = sizeof rooms / sizeof *rooms };

static void print_help(void)
{
    printf("usage: sgfit COMMAND [options]\n\n"
           "Computes and fits the clamped-cosine integral of spherical Gaussians.\n\ncommands:\n");
    for (size_t i = 0; i < ROOMS; i++)
        for (const base_command *command = rooms[i]; command->name; command++)
            printf("  %-10s  %s\n", command->name, command->summary);
    printf(
        "\nsgfit COMMAND --help   tells a command's options\n"
        "sgfit --version        prints the version\n\n"
        "Exit status: 0 done, 1 a check or the work failed, 2 wrong usage or unreadable input.\n");
}

static const base_command *find_command(const char *name)
{
    for (size_t i = 0; i < ROOMS; i++)
        for (const base_command *command = rooms[i]; command->name; command++)
            if (strcmp(command->name, name) == 0)
                return command;
    return NULL;
}

/* Where the caller closed a standard stream, the next file opened would take its place and receive
 * what is meant for the stream: occupy it, such that reading finds the end and writing fails. */
static void occupy_standard_streams(void)
{
    for (int stream = 0; stream <= 2; stream++)
        if (fcntl(stream, F_GETFD) == -1 &&
            open("/dev/null", stream == 2 ? O_WRONLY : O_RDONLY) < 0)
            return;
}

static int run(int argc, char **argv)
{
    if (argc < 2) {
        base_error("expected a command, found nothing (sgfit --help lists them)");
        return BASE_USAGE;
    }
    const char *name = argv[1];
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0) {
        print_help();
        return BASE_DONE;
    }
    if (strcmp(name, "--version") == 0) {
        printf("sgfit %s\n", SG_VERSION);
        return BASE_DONE;
    }
    const base_command *command = find_command(name);
    if (!command) {
        base_error("unknown %s \"%s\", expected one that sgfit --help lists",
                   name[0] == '-' ? "option" : "command", name);
        return BASE_USAGE;
    }
    return command->run(argc - 1, argv + 1);
}

int main(int argc, char **argv)
{
    occupy_standard_streams();
    /* A limit on the size of files is then told as a write that failed, and nothing is left. */
    signal(SIGXFSZ, SIG_IGN);
    fit_profile = profile_fit;
    int status = run(argc, argv);
    /* A command that has already told of its failure has said its one line. */
    if (status != BASE_DONE) {
        fflush(stdout);
        return status;
    }
    return base_finish_stdout() ? BASE_DONE : BASE_FAILED;
}
