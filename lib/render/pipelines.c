/* The table of pipelines. */
#include "hull.h"
#include "internal.h"
#include "meder.h"
#include "multires.h"
#include "shadows.h"
#include "upsample.h"

#include <string.h>

#include "base/buffer.h"
#include "base/text.h"

const render_pipeline *const render_pipelines[] = {
    &exact_pipeline,
    &exact_unclipped_pipeline,
    &limit_pipeline,
    &meder_pipeline,
    /* from few points */
    &hull_pipeline,
    &hull_lobe_pipeline,
    &upsample2_pipeline,
    &upsample4_pipeline,
    &upsample8_pipeline,
    &upsample_sh2_pipeline,
    &upsample_sh4_pipeline,
    &upsample_sh8_pipeline,
    &upsample_far_pipeline,
    &upsample_far6_pipeline,
    &upsample_far4_pipeline,
    /* with shadows */
    &shadows_pipeline,
    &shadows2_pipeline,
    &shadows4_pipeline,
    &multires_pipeline,
    &multires_same_pipeline,
    &multires_apart_pipeline,
    &multires_lobe_pipeline,
    &nichols_pipeline,
    /* the end */
    NULL,
};

const render_pipeline *render_pipeline_find(const char *id)
{
    for (int i = 0; render_pipelines[i]; i++)
        if (strcmp(render_pipelines[i]->id, id) == 0)
            return render_pipelines[i];
    return NULL;
}

const render_pipeline *render_pipeline_choose(const char *id)
{
    const render_pipeline *pipeline = render_pipeline_find(id);
    if (pipeline)
        return pipeline;
    buffer known = {NULL, 0, 0};
    for (int i = 0; render_pipelines[i]; i++)
        buffer_print(&known, "%s%s", i ? ", " : "", render_pipelines[i]->id);
    base_error("--pipeline: expected one of %s, found \"%s\"", known.text, id);
    buffer_free(&known);
    return NULL;
}

char *render_pipelines_help(const char *before)
{
    buffer text = {NULL, 0, 0};
    buffer_add(&text, before);
    buffer_add(&text, "\n\nPipelines; those marked * integrate lobes, by --method, and have a "
                      "--profile:");
    for (int i = 0; render_pipelines[i]; i++) {
        const render_pipeline *p = render_pipelines[i];
        buffer_print(&text, "\n  %-15s  %s%s", p->id, p->title, p->profile ? " *" : "");
    }
    return text.text;
}
