/* profile_cost.c: candidates as shader text, and what that costs. */
#include "profile_fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"

bool profile_counter_open(profile_counter *counter)
{
    char reason[256], *folder = base_join(base_source_root(), "shaders/forms");
    *counter = (profile_counter){0};
    bool good = forms_read(&counter->forms, folder);
    free(folder);
    if (good)
        counter->gpu = cost_counter_open(cost_families[0], reason);
    return good;
}

void profile_counter_close(profile_counter *counter)
{
    cost_counter_close(counter->gpu);
    forms_free(&counter->forms);
}

const char *profile_counter_name(const profile_counter *counter)
{
    return counter->gpu ? cost_families[0] : "static";
}

/* The candidate as a method called profile. False after one line. */
static bool method_of(const profile_counter *counter, const profile_candidate *c, method *made)
{
    *made = (method){.id = "profile",
                     .title = "fitted to a profile",
                     .source = "sgfit fit --profile",
                     .variant = "refit",
                     .year = c->tier->year,
                     .form = forms_find(&counter->forms, c->tier->form->id),
                     .lambda_max = (double)INFINITY,
                     .coefficients = (double *)c->coefficients};
    if (!made->form)
        base_error("shaders/forms: expected %s.glsl, which this program was built with",
                   c->tier->form->id);
    return made->form != NULL;
}

static bool count_one(profile_counter *counter, profile_candidate *c)
{
    method made;
    buffer text = {0};
    cost_count count;
    if (!method_of(counter, c, &made))
        return false;
    if (!counter->gpu)
        return profile_static_count(made.form, c->coefficients, &c->instructions);
    bool good = emit_glsl(&text, &counter->forms, &(method_list){&made, 1}, &made, "", "", &made);
    if (good) {
        buffer_add(&text, "float f(float lambda, float cos_theta)\n{\n"
                          "    return sg_L_profile(lambda, cos_theta);\n}\n");
        good = cost_counter_run(counter->gpu, c->tier->form->id, text.text, &count);
        c->instructions = count.instructions;
    }
    buffer_free(&text);
    return good;
}

bool profile_count(profile_counter *counter, profile_list *candidates)
{
    bool good = true;
    base_progress *progress = base_progress_begin("counting", candidates->count);
    for (size_t i = 0; good && i < candidates->count; i++) {
        good = count_one(counter, &candidates->list[i]);
        base_progress_step(progress, candidates->list[i].tier->form->id);
    }
    base_progress_end(progress);
    return good;
}

bool profile_emit(const profile_counter *counter, const profile_candidate *candidate,
                  const choose_domain *domain, const char *path)
{
    method made;
    buffer text = {0}, title = {0};
    char *lobe_path = base_join(base_source_root(), "shaders/forms/lobe.glsl");
    char *lobe = base_read_file(lobe_path, NULL);
    bool good = lobe && method_of(counter, candidate, &made);
    if (good) {
        made.lambda_min = domain->lambda_min;
        made.lambda_max = domain->lambda_max;
        buffer_print(&title,
                     "fitted to a profile of %zu lights, where its RMSE is %.3g and its largest "
                     "error %.3g",
                     domain->count, candidate->rmse, candidate->max_abs);
        made.title = title.text;
        good = emit_glsl(&text, &counter->forms, &(method_list){&made, 1}, &made, lobe_path, lobe,
                         &made) &&
               base_write_file(path, text.text, text.length);
    }
    buffer_free(&text);
    buffer_free(&title);
    free(lobe);
    free(lobe_path);
    return good;
}
