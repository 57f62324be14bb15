/* eval.h: the commands `sgfit eval` and `sgfit methods`. */
#ifndef FIT_EVAL_H
#define FIT_EVAL_H

int eval_command(int argc, char **argv);
int methods_command(int argc, char **argv);

#endif
