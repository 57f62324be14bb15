/* commands.h: what this room adds to the program. */
#ifndef RENDER_COMMANDS_H
#define RENDER_COMMANDS_H

#include "base/options.h"

extern const base_command render_commands[];

#endif
