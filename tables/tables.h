/* tables.h: what the room of numbers gives the program. */
#ifndef TABLES_TABLES_H
#define TABLES_TABLES_H

#include "base/options.h"

extern const base_command tables_commands[];

#endif
