/* machine.h: what a measurement was made with, for the files that hold it. */
#ifndef BENCH_MACHINE_H
#define BENCH_MACHINE_H

#include <stddef.h>

#include <cjson/cJSON.h>

/* Processor, cores, system, compiler, C library, version of this program. */
void machine_add_json(cJSON *object);

/* The model of the processor, "unknown" where the system does not tell. */
void machine_processor(char *text, size_t size);

#endif
