#include "csv.h"

#include "text.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool grow_row(base_csv *csv)
{
    size_t capacity = csv->row_capacity ? 2 * csv->row_capacity : 256;
    char *row = realloc(csv->row, capacity);
    if (row)
        csv->row = row;
    char *copy = row ? realloc(csv->copy, capacity) : NULL;
    if (copy) {
        csv->copy = copy;
        csv->row_capacity = capacity;
    }
    return copy != NULL;
}

/* The next line as it stands into csv->row, quoted line ends included. 1, 0 at the end, -1 after
 * one line. */
static int read_row(base_csv *csv)
{
    csv->line = csv->next_line;
    size_t length = 0;
    /* A quote counts at the start of a field only; behind a closing one it is a quote itself. */
    bool quoted = false, closing = false, start = true;
    int c;
    errno = 0;
    while ((c = getc_unlocked(csv->stream)) != EOF) {
        if (c == '\n') {
            csv->next_line++;
            if (!quoted)
                break;
        }
        if (c == '\0') {
            base_error("%s, line %ld: expected text, found a NUL byte", csv->name, csv->line);
            return -1;
        }
        bool quote = c == '"' && (quoted || closing || start);
        closing = quote && quoted;
        quoted = quote ? !quoted : quoted;
        start = c == ',' && !quoted;
        if (length + 2 > csv->row_capacity && (length >= BASE_CSV_LONGEST_ROW || !grow_row(csv))) {
            base_error("%s, line %ld: expected a row of at most %d bytes", csv->name, csv->line,
                       BASE_CSV_LONGEST_ROW);
            return -1;
        }
        csv->row[length++] = (char)c;
    }
    if (c == EOF && ferror(csv->stream)) {
        base_error("cannot read %s: %s", csv->name, strerror(errno ? errno : EIO));
        return -1;
    }
    if (c == EOF && length == 0)
        return 0;
    if (!csv->row && !grow_row(csv))
        return -1;
    if (length > 0 && csv->row[length - 1] == '\r')
        length--;
    csv->row[length] = '\0';
    csv->row_length = length;
    return 1;
}

static bool add_field(base_csv *csv, size_t start, size_t length)
{
    if (csv->field_count == csv->field_capacity) {
        size_t capacity = csv->field_capacity ? 2 * csv->field_capacity : 16;
        size_t *starts = realloc(csv->starts, capacity * sizeof *starts);
        if (starts)
            csv->starts = starts;
        size_t *lengths = realloc(csv->lengths, capacity * sizeof *lengths);
        if (lengths)
            csv->lengths = lengths;
        char **fields = realloc(csv->fields, capacity * sizeof *fields);
        if (fields)
            csv->fields = fields;
        if (!starts || !lengths || !fields) {
            base_error("%s, line %ld: out of memory", csv->name, csv->line);
            return false;
        }
        csv->field_capacity = capacity;
    }
    csv->starts[csv->field_count] = start;
    csv->lengths[csv->field_count] = length;
    csv->field_count++;
    return true;
}

/* Copies one quoted field from p, just behind its opening quote, to csv->copy + *used; returns
 * where the field ends, NULL after one line. */
static const char *copy_quoted(base_csv *csv, const char *p, size_t *used)
{
    const char *end = csv->row + csv->row_length;
    for (; p < end; p++) {
        if (*p == '"') {
            if (p + 1 == end || p[1] != '"')
                break;
            p++;
        }
        csv->copy[(*used)++] = *p;
    }
    if (p == end) {
        base_error("%s, line %ld: expected a closing quote, found the end of the input", csv->name,
                   csv->line);
        return NULL;
    }
    p++;
    if (p < end && *p != ',') {
        base_error("%s, line %ld: expected a comma after the closing quote of field %zu", csv->name,
                   csv->line, csv->field_count + 1);
        return NULL;
    }
    return p;
}

/* Splits csv->row into fields, each NUL-terminated in the copy: every comma or line end leaves
 * room for one NUL, so that the copy is never longer than the row with its own. */
static bool split_row(base_csv *csv)
{
    csv->field_count = 0;
    const char *p = csv->row, *end = csv->row + csv->row_length;
    size_t used = 0;
    for (;;) {
        size_t start = used;
        if (p < end && *p == '"') {
            if (!(p = copy_quoted(csv, p + 1, &used)))
                return false;
        } else {
            const char *comma = memchr(p, ',', (size_t)(end - p));
            size_t length = (size_t)((comma ? comma : end) - p);
            memcpy(csv->copy + used, p, length);
            used += length;
            p += length;
        }
        if (!add_field(csv, start, used - start))
            return false;
        csv->copy[used++] = '\0';
        if (p == end)
            break;
        p++; /* the comma */
    }
    for (size_t i = 0; i < csv->field_count; i++)
        csv->fields[i] = csv->copy + csv->starts[i];
    return true;
}

/* A row that is not blank, split; as base_csv_next, but of any number of fields. */
static int next_fields(base_csv *csv)
{
    for (;;) {
        int status = read_row(csv);
        if (status <= 0)
            return status;
        if (strspn(csv->row, " \t") == csv->row_length)
            continue;
        return split_row(csv) ? 1 : -1;
    }
}

static bool keep_header(base_csv *csv)
{
    csv->header = calloc(csv->field_count, sizeof *csv->header);
    if (!csv->header)
        return false;
    for (size_t i = 0; i < csv->field_count; i++) {
        const char *name = csv->fields[i];
        name += strspn(name, " \t");
        size_t length = strlen(name);
        while (length > 0 && (name[length - 1] == ' ' || name[length - 1] == '\t'))
            length--;
        if (!(csv->header[i] = strndup(name, length)))
            return false;
        csv->columns = i + 1;
        for (size_t k = 0; k < i; k++) {
            if (strcmp(csv->header[i], csv->header[k]) == 0) {
                base_error("%s, line %ld: expected column names that differ, found \"%s\" twice",
                           csv->name, csv->line, csv->header[i]);
                return false;
            }
        }
    }
    return true;
}

bool base_csv_open(base_csv *csv, FILE *stream, const char *name)
{
    *csv = (base_csv){.stream = stream, .name = name, .next_line = 1};
    /* A byte order mark of UTF-8, as spreadsheets write it. */
    int c = getc(stream);
    if (c == 0xef) {
        if (getc(stream) != 0xbb || getc(stream) != 0xbf) {
            base_error("%s, line 1: expected a header of column names", name);
            return false;
        }
    } else if (c != EOF) {
        ungetc(c, stream);
    }
    int status = next_fields(csv);
    if (status == 0)
        base_error("%s: expected a header of column names, found nothing", name);
    return status == 1 && keep_header(csv);
}

int base_csv_column(const base_csv *csv, const char *name)
{
    for (size_t i = 0; i < csv->columns; i++)
        if (strcmp(csv->header[i], name) == 0)
            return (int)i;
    return -1;
}

int base_csv_next(base_csv *csv)
{
    int status = next_fields(csv);
    if (status == 1 && csv->field_count != csv->columns) {
        base_error("%s, line %ld: expected %zu field%s as in the header, found %zu", csv->name,
                   csv->line, csv->columns, csv->columns == 1 ? "" : "s", csv->field_count);
        return -1;
    }
    return status;
}

void base_csv_error(const base_csv *csv, int column, const char *expected)
{
    const char *field = csv->fields[column];
    enum { SHOWN = 40 };
    base_error("%s, line %ld, column %s: expected %s, found \"%.*s\"%s", csv->name, csv->line,
               csv->header[column], expected, (int)SHOWN, field,
               csv->lengths[column] > SHOWN ? "..." : "");
}

bool base_csv_f64(const base_csv *csv, int column, double *value)
{
    if (base_parse_f64(csv->fields[column], csv->lengths[column], value) && isfinite(*value))
        return true;
    base_csv_error(csv, column, "a finite number");
    return false;
}

void base_csv_close(base_csv *csv)
{
    for (size_t i = 0; csv->header && i < csv->columns; i++)
        free(csv->header[i]);
    free(csv->header);
    free(csv->row);
    free(csv->copy);
    free(csv->fields);
    free(csv->lengths);
    free(csv->starts);
    *csv = (base_csv){0};
}
