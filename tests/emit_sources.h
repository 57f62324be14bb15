/* emit_sources.h: a copy of the sources in a temporary folder, with a form and a method more. */
#ifndef TESTS_EMIT_SOURCES_H
#define TESTS_EMIT_SOURCES_H

#include "program.h"
#include "workspace.h"

static const char new_form[] = "// test_form: twice the clamped cosine, for the test.\n"
                               "// computes: L\n"
                               "// coefficients: gain\n"
                               "real sg_form(real lambda, real cos_theta)\n"
                               "{\n"
                               "    bool lit = cos_theta > K(0.0);\n"
                               "    return lit ? gain * cos_theta - K(-0.5) : sg_mean(lambda);\n"
                               "}\n";
static const char new_method[] =
    "{\"id\": \"test_method\", \"title\": \"A \\\"test\\\"\", \"variant\": \"tier\",\n"
    " \"year\": 2001, \"source\": \"nowhere\", \"form\": \"test_form\",\n"
    " \"domain\": {\"lambda\": [0.5, 10]},\n"
    " \"coefficients\": {\"gain\": 2}}\n";

/* The work folder anew: forms, constants and the costs, if there are any. */
static inline void copy_sources(workspace *work)
{
    const char *root = getenv("SGFIT_ROOT");
    if (shell(
            "cd '%s' && rm -rf ./* && mkdir shaders tables && cp -r '%s/shaders/forms' shaders && "
            "cp -r '%s/tables/constants' tables && "
            "if [ -e '%s/tables/cost.csv' ]; then cp '%s/tables/cost.csv' tables; fi",
            work->folder, root, root, root, root) != 0)
        abort();
}

static inline run emit_copy(workspace *work)
{
    return RUN(NULL, "emit", "--root", work->folder);
}

#endif
