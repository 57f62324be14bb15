/* cost.c: tables/cost.csv, which the bench measures, as one line a method. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/csv.h"
#include "base/text.h"
#include "constants.h"

typedef struct columns {
    int id, quantity, instructions, throughput;
} columns;

/* The cost of the function as shipped, or, where the file has no such columns, of the function
 * alone. False after one line. */
static bool find_columns(const base_csv *csv, columns *found)
{
    found->id = base_csv_column(csv, "method");
    found->quantity = base_csv_column(csv, "quantity");
    found->instructions = base_csv_column(csv, "gpu_include_instructions");
    found->throughput = base_csv_column(csv, "gpu_include_inverse_throughput");
    if (found->instructions < 0) {
        found->instructions = base_csv_column(csv, "gpu_instructions");
        found->throughput = base_csv_column(csv, "gpu_inverse_throughput");
    }
    if (found->id >= 0 && found->quantity >= 0 && found->instructions >= 0)
        return true;
    base_error("%s:1: expected columns method, quantity and gpu_instructions", csv->name);
    return false;
}

static void add_cost(method *method, const base_csv *csv, const columns *at)
{
    const char *quantity = csv->fields[at->quantity];
    const char *instructions = csv->fields[at->instructions];
    if (!*instructions)
        return;
    buffer text = {0};
    buffer_print(&text, "%s%s%s %s instructions", method->cost ? method->cost : "",
                 method->cost ? "; " : "", quantity, instructions);
    if (at->throughput >= 0 && *csv->fields[at->throughput])
        buffer_print(&text, ", inverse throughput %s", csv->fields[at->throughput]);
    free(method->cost);
    method->cost = text.text;
    if (strcmp(quantity, "A_h") == 0) {
        free(method->instructions);
        method->instructions = base_copy(instructions, strlen(instructions));
    }
}

bool methods_read_costs(method_list *list, const char *path)
{
    FILE *stream = fopen(path, "r");
    if (!stream)
        return true;
    base_csv csv;
    columns at;
    bool good = base_csv_open(&csv, stream, path);
    if (good) {
        int row = -1;
        if (find_columns(&csv, &at)) {
            while ((row = base_csv_next(&csv)) > 0) {
                method *method = (struct method *)methods_find(list, csv.fields[at.id]);
                if (method)
                    add_cost(method, &csv, &at);
            }
        }
        good = row == 0;
        base_csv_close(&csv);
    }
    fclose(stream);
    return good;
}
