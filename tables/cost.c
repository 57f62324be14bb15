/* cost.c: tables/cost.csv, which the bench measures, as one line a method. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/csv.h"
#include "constants.h"

bool methods_read_costs(method_list *list, const char *path)
{
    FILE *stream = fopen(path, "r");
    if (!stream)
        return true;
    base_csv csv;
    bool good = base_csv_open(&csv, stream, path);
    if (good) {
        int id = base_csv_column(&csv, "method"), quantity = base_csv_column(&csv, "quantity");
        int instructions = base_csv_column(&csv, "gpu_instructions");
        int throughput = base_csv_column(&csv, "gpu_inverse_throughput");
        int row;
        while ((row = base_csv_next(&csv)) > 0) {
            method *method = id < 0 ? NULL : (struct method *)methods_find(list, csv.fields[id]);
            if (!method || quantity < 0 || instructions < 0)
                continue;
            buffer text = {0};
            if (method->cost)
                buffer_print(&text, "%s; ", method->cost);
            buffer_print(&text, "%s %s instructions", csv.fields[quantity],
                         csv.fields[instructions]);
            if (throughput >= 0)
                buffer_print(&text, ", inverse throughput %s", csv.fields[throughput]);
            free(method->cost);
            method->cost = text.text;
        }
        good = row == 0;
        base_csv_close(&csv);
    }
    fclose(stream);
    return good;
}
