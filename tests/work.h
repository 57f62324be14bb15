/* work.h: one temporary folder for all tests of a program, and the fixtures that make and remove
 * it. */
#ifndef TESTS_WORK_H
#define TESTS_WORK_H

#include "workspace.h"

static workspace work;

static inline int open_work(void **state)
{
    (void)state;
    workspace_open(&work);
    return 0;
}

static inline int close_work(void **state)
{
    (void)state;
    workspace_close(&work);
    return 0;
}

#endif
