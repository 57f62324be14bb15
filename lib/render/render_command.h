/* render_command.h: inside lib/render. */
#ifndef RENDER_RENDER_COMMAND_H
#define RENDER_RENDER_COMMAND_H

int render_command(int argc, char **argv);

#endif
