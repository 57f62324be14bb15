/* profile_fit.c: sgfit fit --profile. */
#include "profile_fit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"

/* With most (an error): by cost, then by error. Else by error, then by cost. */
static bool better(const profile_candidate *a, const profile_candidate *b, bool by_max, bool cheap)
{
    double x = profile_error(a, by_max), y = profile_error(b, by_max);
    if (cheap)
        return a->instructions != b->instructions ? a->instructions < b->instructions : x < y;
    return x != y ? x < y : a->instructions < b->instructions;
}

const profile_candidate *profile_choose(const profile_list *candidates, bool by_max, double budget,
                                        double most)
{
    const profile_candidate *best = NULL;
    for (size_t i = 0; i < candidates->count; i++) {
        const profile_candidate *c = &candidates->list[i];
        if (!c->safe || !(c->instructions <= budget) ||
            (!isnan(most) && !(profile_error(c, by_max) <= most)))
            continue;
        if (!best || better(c, best, by_max, !isnan(most)))
            best = c;
    }
    return best;
}

/* ---- Output -------------------------------------------------------------------------------- */

static void print_row(const char *role, const profile_candidate *c, const char *counted,
                      double saved)
{
    char number[4][BASE_NUMBER_SIZE];
    const sg_form *form = c->tier->form;
    printf("%s,%s,%s,", role, form->id, c->fitted ? "" : c->tier->id);
    bool first = true;
    for (int i = 0; i < form->coefficient_count; i++) {
        if (c->dropped[i])
            printf("%s%s", first ? "" : " ", form->coefficient_names[i]);
        first = first && !c->dropped[i];
    }
    printf(",%s,%s,%s,%s,%s,%s\n", base_shortest_f64(c->instructions, number[0]), counted,
           base_shortest_f64(c->max_abs, number[1]), base_shortest_f64(c->rmse, number[2]),
           c->safe ? "yes" : "no", isnan(saved) ? "" : base_shortest_f64(saved, number[3]));
}

static void print_all(const profile_list *ladder, const profile_candidate *chosen,
                      const profile_candidate *general, const char *counted)
{
    puts("role,form,tier,dropped,instructions,counted,max_abs,rmse,safe,saved");
    for (size_t i = 0; i < ladder->count; i++)
        if (&ladder->list[i] != chosen)
            print_row("candidate", &ladder->list[i], counted, (double)NAN);
    print_row("chosen", chosen, counted,
              general ? general->instructions - chosen->instructions : (double)NAN);
    if (general)
        print_row("general", general, counted, (double)NAN);
}

/* ---- The work ------------------------------------------------------------------------------ */

typedef struct work {
    const fit_profile_request *request;
    choose_domain domain;
    profile_counter counter;
    profile_list tiers, ladder;
    double budget, most; /* infinite and NaN where not asked for */
} work;

/* Where neither is given, the error to meet is that of the cheapest tier on this profile. */
static void find_wish(work *w)
{
    const fit_profile_request *r = w->request;
    w->budget = r->budget_given ? r->budget : (double)INFINITY;
    w->most = r->max_error_given ? r->max_error : (double)NAN;
    if (r->budget_given || r->max_error_given)
        return;
    const profile_candidate *cheapest = NULL;
    for (size_t i = 0; i < w->tiers.count; i++)
        if (!cheapest || w->tiers.list[i].instructions < cheapest->instructions)
            cheapest = &w->tiers.list[i];
    w->most = profile_error(cheapest, r->by_max);
}

/* How far down ladders go: where an error is asked for, to it; else to what no shader should bear.
 */
static double depth(const work *w)
{
    return isnan(w->most) ? 0.05 : w->most;
}

static bool write_files(work *w, const profile_candidate *chosen, const profile_candidate *general)
{
    const fit_profile_request *r = w->request;
    return (!r->out || profile_write(r, &w->domain, &w->counter, chosen, general)) &&
           (!r->emit || profile_emit(&w->counter, chosen, &w->domain, r->emit));
}

static int search(work *w)
{
    bool by_max = w->request->by_max;
    if (!profile_tiers(&w->domain, &w->tiers) || !profile_count(&w->counter, &w->tiers))
        return BASE_FAILED;
    find_wish(w);
    if (!profile_ladders(&w->domain, by_max, depth(w), &w->ladder) ||
        !profile_count(&w->counter, &w->ladder))
        return BASE_FAILED;
    const profile_candidate *chosen = profile_choose(&w->ladder, by_max, w->budget, w->most);
    if (!chosen) {
        double cheapest = (double)INFINITY;
        for (size_t i = 0; i < w->ladder.count; i++)
            cheapest = fmin(cheapest, w->ladder.list[i].instructions);
        base_error("fit: no candidate meets this on the profile: the cheapest that was tried needs "
                   "%g instructions",
                   cheapest);
        return BASE_FAILED;
    }
    double bar = isnan(w->most) ? profile_error(chosen, by_max) : w->most;
    const profile_candidate *general = profile_choose(&w->tiers, by_max, (double)INFINITY, bar);
    if (!write_files(w, chosen, general))
        return BASE_FAILED;
    print_all(&w->ladder, chosen, general, profile_counter_name(&w->counter));
    return base_finish_stdout() ? BASE_DONE : BASE_FAILED;
}

int profile_fit(const fit_profile_request *request)
{
    work w = {.request = request};
    if (!choose_profile(&w.domain, request->profile))
        return BASE_USAGE;
    int status = BASE_FAILED;
    bool writable = (!request->out || base_can_write(request->out)) &&
                    (!request->emit || base_can_write(request->emit));
    if (writable && profile_counter_open(&w.counter))
        status = search(&w);
    profile_counter_close(&w.counter);
    free(w.tiers.list);
    free(w.ladder.list);
    choose_domain_free(&w.domain);
    return status;
}
