/* test_report.c: `sgfit report` as its readers meet it: the files and the page. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <ctype.h>
#include <math.h>
#include <sys/stat.h>

#include "base/csv.h"
#include "base/file.h"
#include "program.h"
#include "sg.h"
#include "work.h"

static char out[300];
static char *page;

static int tear_down(void **state)
{
    (void)state;
    free(page);
    workspace_close(&work);
    return 0;
}

/* The report is written once; the tests look at it. */
static int set_up(void **state)
{
    (void)state;
    workspace_open(&work);
    snprintf(out, sizeof out, "%s/new/report", work.folder);
    run r = program_run((const char *[]){"report", "--out", out, NULL}, NULL);
    if (r.status != 0)
        fprintf(stderr, "status %d: %s", r.status, r.error);
    int status = r.status || r.error[0];
    run_free(&r);
    char path[400];
    snprintf(path, sizeof path, "%s/index.html", out);
    page = status ? NULL : base_read_file(path, &(size_t){0});
    return page ? 0 : -1;
}

static bool is_there(const char *name, size_t length)
{
    char path[400];
    struct stat about;
    snprintf(path, sizeof path, "%s/%.*s", out, (int)length, name);
    return stat(path, &about) == 0 && S_ISREG(about.st_mode) && about.st_size > 20;
}

static void the_csv_has_every_method_in_every_precision(void **state)
{
    (void)state;
    static const char header[] =
        "method,precision,max_abs,max_abs_lambda,max_abs_beta,rmse,max_rel_1e-2,max_rel_1e-4\n";
    static const char *const precisions[] = {"f64", "f32", "f16"};
    char path[400];
    snprintf(path, sizeof path, "%s/accuracy.csv", out);
    char *text = base_read_file(path, &(size_t){0});
    assert_non_null(text);
    assert_memory_equal(text, header, sizeof header - 1);
    free(text);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    base_csv csv;
    assert_true(base_csv_open(&csv, file, path));
    for (size_t i = 0; i < sg_method_count(); i++)
        for (int p = 0; p < 3; p++) {
            assert_int_equal(base_csv_next(&csv), 1);
            assert_string_equal(csv.fields[0], sg_method_at(i)->id);
            assert_string_equal(csv.fields[1], precisions[p]);
            double error = strtod(csv.fields[2], NULL), rmse = strtod(csv.fields[5], NULL);
            assert_true(error > 0.0 && rmse > 0.0 && rmse <= error);
            if (p == 0 && strcmp(csv.fields[0], "tokuyoshi_2024") == 0)
                assert_true(fabs(error - 1.28e-3) < 5e-6 && fabs(rmse - 1.94e-4) < 1e-6);
        }
    assert_int_equal(base_csv_next(&csv), 0);
    base_csv_close(&csv);
    fclose(file);
}

/* Elements that have no end tag; SVG's close themselves with "/>". */
static bool is_void(const char *name)
{
    static const char *const names[] = {"meta", "br", "link", "hr", "img", "input", NULL};
    for (int i = 0; names[i]; i++)
        if (strcmp(name, names[i]) == 0)
            return true;
    return name[0] == '!';
}

static const char *tag_end(const char *at)
{
    char quote = '\0';
    for (; *at && (quote || *at != '>'); at++)
        if (quote ? *at == quote : (*at == '"' || *at == '\''))
            quote = quote ? '\0' : *at;
    return at;
}

static void every_element_is_closed(void **state)
{
    (void)state;
    enum { DEPTH = 64, NAME = 32 };
    static char open[DEPTH][NAME];
    int depth = 0, elements = 0;
    for (const char *at = strchr(page, '<'); at; at = strchr(at, '<')) {
        bool closing = at[1] == '/';
        const char *name = at + 1 + closing, *end = tag_end(at);
        char text[NAME] = "";
        for (size_t i = 0; i + 1 < NAME && (isalnum((unsigned char)name[i]) || name[i] == '!'); i++)
            text[i] = name[i];
        assert_true(*end == '>' && text[0]);
        if (closing) {
            assert_true(depth > 0);
            assert_string_equal(open[--depth], text);
        } else if (end[-1] != '/' && !is_void(text)) {
            assert_true(depth < DEPTH);
            strcpy(open[depth++], text);
            elements++;
        }
        at = end;
        if (!closing && (strcmp(text, "style") == 0 || strcmp(text, "script") == 0)) {
            at = strstr(end, closing ? "" : "</"); /* no markup in there */
            assert_non_null(at);
        }
    }
    assert_int_equal(depth, 0);
    assert_true(elements > 500);
}

static void nothing_is_loaded_from_elsewhere(void **state)
{
    (void)state;
    static const char *const forbidden[] = {"http:", "https:", "//cdn",   "@import", "url(",
                                            "<link", "<img",   "<iframe", "src=",    NULL};
    for (int i = 0; forbidden[i]; i++)
        if (strstr(page, forbidden[i]))
            fail_msg("the page holds %s: %.80s", forbidden[i], strstr(page, forbidden[i]));
}

/* Ids are unique, and links lead to an id or to a file of the report. */
static void every_link_leads_somewhere(void **state)
{
    (void)state;
    int links = 0, ids = 0;
    for (const char *at = page; (at = strpbrk(at, "h'\"i")); at++) {
        char quote, wanted[2][160];
        if (sscanf(at, "href=%c", &quote) == 1 && (quote == '"' || quote == '\'')) {
            const char *target = at + 6;
            size_t length = strcspn(target, (char[]){quote, '\0'});
            if (*target == '#') {
                snprintf(wanted[0], 160, " id=\"%.*s\"", (int)length - 1, target + 1);
                snprintf(wanted[1], 160, " id='%.*s'", (int)length - 1, target + 1);
                if (!strstr(page, wanted[0]) && !strstr(page, wanted[1]))
                    fail_msg("a link leads nowhere: %.*s", (int)length, target);
            } else if (!is_there(target, length))
                fail_msg("a linked file is missing: %.*s", (int)length, target);
            links++;
        }
        if (at > page && at[-1] == ' ' && sscanf(at, "id=%c", &quote) == 1) {
            snprintf(wanted[0], 160, " %.*s%c", (int)strcspn(at + 4, (char[]){quote, '\0'}) + 4, at,
                     quote);
            if (strstr(at + 4, wanted[0]))
                fail_msg("an id stands twice:%s", wanted[0]);
            ids++;
        }
    }
    assert_true(links > 40 && ids > 20);
}

static void the_papers_figures_are_drawn(void **state)
{
    (void)state;
    static const char *const ids[] = {"meder_5a",    "meder_6",     "meder_7", "meder_7_L",
                                      "tokuyoshi_2", "tokuyoshi_3", NULL};
    for (int i = 0; ids[i]; i++) {
        char name[64];
        snprintf(name, sizeof name, "data/%s.csv", ids[i]);
        assert_true(is_there(name, strlen(name)));
        assert_non_null(strstr(page, name));
        snprintf(name, sizeof name, "figures/%s.svg", ids[i]);
        assert_true(is_there(name, strlen(name)));
        snprintf(name, sizeof name, "id=\"%s_plot_1\"", ids[i]); /* gnuplot's first curve */
        assert_non_null(strstr(page, name));
    }
    /* what is compared in figure 2 is there, under whichever names a form has its constants */
    char path[400];
    snprintf(path, sizeof path, "%s/data/tokuyoshi_2.csv", out);
    char *csv = base_read_file(path, &(size_t){0});
    assert_non_null(csv);
    assert_non_null(strstr(csv, ",meder_2018_hg,"));
    assert_non_null(strstr(csv, ",tokuyoshi_2022"));
    free(csv);
    /* a curve that gnuplot drew without a point would be a figure of axes */
    for (const char *plot = strstr(page, "_plot_1\""); plot; plot = strstr(plot + 1, "_plot_1\"")) {
        const char *close = strstr(plot, "</g>\n\t</g>"), *line = strstr(plot, " L");
        const char *point = strstr(plot, "<use");
        assert_non_null(close);
        assert_true((line && line < close) || (point && point < close));
    }
}

static void each_section_is_in_the_navigation(void **state)
{
    (void)state;
    int sections = 0;
    for (const char *at = page; (at = strstr(at, "<section id=\"")); at++) {
        char wanted[64];
        snprintf(wanted, sizeof wanted, "<li><a href=\"#%.*s\">", (int)strcspn(at + 13, "\""),
                 at + 13);
        assert_non_null(strstr(page, wanted));
        sections++;
    }
    assert_true(sections >= 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_csv_has_every_method_in_every_precision),
        cmocka_unit_test(every_element_is_closed),
        cmocka_unit_test(nothing_is_loaded_from_elsewhere),
        cmocka_unit_test(every_link_leads_somewhere),
        cmocka_unit_test(the_papers_figures_are_drawn),
        cmocka_unit_test(each_section_is_in_the_navigation),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
