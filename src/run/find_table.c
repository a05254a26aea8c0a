/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/find_table.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/disk.h"
#include "base/text.h"
#include "run/csv.h"
#include "run/internal.h"

static const char heads[] =
    "value,quantity,order,level,converged,marked,seconds,message\n";

/* The number before a comma at *text, which moves behind it; an empty cell is
 * none. */
static bool read_cell(const char **text, double *value)
{
    *value = NAN;
    if (**text != ',' && !ovr_read_number(text, value))
        return false;
    return *(*text)++ == ',';
}

/* A whole line; the last one may be cut. */
static bool read_row(char *line, ovr_find_evaluation *e, ovr_arena *arena)
{
    double cell[7] = {0};
    const char *at = line;
    size_t size = strcspn(line, "\n");
    if (!line[size])
        return false;
    line[size] = '\0';
    for (int k = 0; k < 7; k++)
        if (!read_cell(&at, &cell[k]))
            return false;
    *e = (ovr_find_evaluation){cell[0],      cell[1],
                               (int)cell[2], (int)cell[3],
                               cell[4] > 0,  (long)cell[5],
                               cell[6],      ovr_arena_text(arena, at, NULL)};
    return isfinite(e->value) && e->message;
}

static void put_row(FILE *to, const ovr_find_evaluation *e)
{
    ovr_csv_number(to, e->value, 17);
    fputc(',', to);
    ovr_csv_number(to, isfinite(e->quantity) ? e->quantity : NAN, 17);
    fprintf(to, ",%d,%d,%d,%ld,", e->order, e->level, e->converged, e->marked);
    ovr_csv_number(to, e->seconds, 17);
    fputc(',', to);
    for (const char *c = e->message; *c; c++)
        fputc(*c == ',' || *c == '"' || *c == '\n' ? ';' : *c, to);
    fputc('\n', to);
}

static ovr_status cannot(const ovr_find_table *t, ovr_status status,
                         ovr_error *err)
{
    return ovr_fail(err, status, "%s: cannot be written: %s", t->path,
                    strerror(errno));
}

/* The whole rows of a file; what stands behind them is cut off. */
static size_t read_rows(const ovr_find_table *t, ovr_arena *arena)
{
    FILE *from = t->file;
    char line[2048];
    size_t count = 0;
    long end = 0;
    if (fgets(line, sizeof line, from) && !strcmp(line, heads)) {
        end = ftell(from);
        while (count < t->maximum && fgets(line, sizeof line, from) &&
               read_row(line, &t->made[count], arena)) {
            count++;
            end = ftell(from);
        }
    }
    if (ftruncate(fileno(from), end) != 0 || fseek(from, end, SEEK_SET) != 0)
        return 0;
    if (end == 0)
        fputs(heads, from);
    return count;
}

ovr_status ovr_find_table_open(ovr_find_table *table, bool go_on, bool force,
                               ovr_arena *arena, ovr_error *err)
{
    if (!force && ovr_file_ours(table->path, heads, err))
        return OVR_BAD_INPUT;
    table->file = go_on ? fopen(table->path, "r+") : NULL;
    if (table->file) {
        table->count = read_rows(table, arena);
    } else {
        table->file = fopen(table->path, "w");
        if (table->file)
            fputs(heads, table->file);
    }
    if (!table->file)
        return cannot(table, OVR_BAD_INPUT, err);
    return fflush(table->file) == 0 ? OVR_OK : cannot(table, OVR_IO, err);
}

ovr_status ovr_find_table_add(ovr_find_table *table,
                              const ovr_find_evaluation *one, ovr_error *err)
{
    if (!table->file)
        return OVR_OK;
    put_row(table->file, one);
    if (fflush(table->file) == 0 && fsync(fileno(table->file)) == 0)
        return OVR_OK;
    return cannot(table, OVR_IO, err);
}

void ovr_find_table_close(ovr_find_table *table)
{
    if (table->file)
        fclose(table->file);
    table->file = NULL;
}
