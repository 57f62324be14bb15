/* report_profile.c: the section "No more than a scene needs". */
#include <stdlib.h>

#include "base/text.h"
#include "html.h"
#include "profile_fit.h"
#include "report.h"

bool report_has_profile(const report *report)
{
    return report->bench != NULL;
}

static int terms_left(const profile_candidate *candidate)
{
    int left = 0;
    for (int i = 0; i < candidate->tier->form->coefficient_count; i++)
        left += !candidate->dropped[i];
    return left;
}

static void write_row(page *page, FILE *csv, const profile_saving *saving)
{
    const profile_candidate *fitted = &saving->fitted;
    double before = saving->general.instructions, after = fitted->instructions;
    const double numbers[] = {saving->lambda_min,
                              saving->lambda_max,
                              saving->bar,
                              saving->general.instructions,
                              fitted->instructions,
                              fitted->rmse,
                              100.0 * (before - after) / before};
    html_row_begin(page, NULL);
    html_cell(page, saving->profile);
    html_cell_code(page, saving->general.tier->id);
    html_cell_code(page, fitted->tier->id);
    html_cell_number(page, terms_left(fitted), 3);
    fprintf(csv, "%s,%s,%s,%d", saving->profile, saving->general.tier->id, fitted->tier->id,
            terms_left(fitted));
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        char text[BASE_NUMBER_SIZE];
        html_cell_number(page, numbers[i], 3);
        fprintf(csv, ",%s", base_shortest_f64(numbers[i], text));
    }
    fputc('\n', csv);
    html_row_end(page);
}

bool report_profile(report *report)
{
    static const char *const columns[] = {"profile", "tier",  "fitted form", "#terms",
                                          "#λ from", "#to",   "#RMSE",       "#instructions",
                                          "#fitted", "#RMSE", "#saved %",    NULL};
    size_t count;
    const char *unit;
    profile_saving *savings = profile_savings(&count, &unit);
    if (!savings)
        return false;
    page *page = report->page;
    html_paragraph(
        page,
        "A tier serves any lobe at any angle; one scene has lobes of its own. `sgfit fit "
        "--profile FILE` fits the same forms to (lambda, cos_theta, weight) as a scene "
        "produces them, dropping every term that its error does not need. At the error "
        "that a tier has on a profile, what is saved (%s):",
        unit);
    FILE *csv = page_file_begin(page, "data/profiles.csv");
    fputs("profile,tier,form,terms,lambda_from,lambda_to,rmse,instructions,fitted_instructions,"
          "fitted_rmse,saved_percent\n",
          csv);
    html_table_begin(page, "Instructions for one L, at equal RMSE or less over the profile.",
                     columns);
    for (size_t i = 0; i < count; i++)
        write_row(page, csv, &savings[i]);
    page_file_end(page);
    html_table_end(page, "data/profiles.csv");
    free(savings);
    return true;
}
