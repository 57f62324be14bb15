/* commands.c: what this room adds to the program. */
#include "commands.h"

#ifdef HAVE_RENDER
#include "render_command.h"
#else
#include "base/text.h"

static int render_command(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    base_error("render: this program was built without %s", RENDER_MISSING);
    return BASE_FAILED;
}
#endif

const base_command render_commands[] = {
    {"render", "runs the validation renderer on a scene", render_command},
    {NULL, NULL, NULL},
};
