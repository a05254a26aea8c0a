/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opening a result file: what is in it, and how much of it is complete. */
#include "results/reader.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "results/journal.h"
#include "results/turns.h"

enum { MAX_COLUMNS = 256 };

/* ------------------------------------------------------------- datasets */

bool ovr_reader_dataset(ovr_result *r, const char *path, ovr_dataset *set)
{
    ovr_container *c = &r->container;
    uint64_t object = c->root;
    char name[64];
    while (*path) {
        size_t length = strcspn(path, "/");
        if (length >= sizeof name)
            return false;
        snprintf(name, sizeof name, "%.*s", (int)length, path);
        if (!ovr_container_find(c, object, name, &object))
            return false;
        path += length + (path[length] == '/');
    }
    return ovr_container_dataset(c, object, set);
}

/* How many values stand before the first NaN, which begins the rows that are
 * not complete yet. */
static size_t complete_rows(ovr_result *r, const ovr_dataset *set, size_t rows)
{
    ovr_container *c = &r->container;
    size_t low = 0, high = rows;
    double value;
    if (rows && ovr_container_values(c, set, rows - 1, 1, &value) &&
        !isnan(value))
        return rows;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (ovr_container_values(c, set, middle, 1, &value) && !isnan(value))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* -------------------------------------------------------------- opening */

/* Texts of strangers reach terminals: what would command one becomes a space,
 * the C1 controls of UTF-8 (0xc2 0x80 to 0xc2 0x9f) with it.  Only a case has
 * lines. */
static void make_plain(char *text, bool has_lines)
{
    unsigned char before = 0;
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        bool line = has_lines && (c == '\n' || c == '\t' || c == '\r');
        if ((c < 0x20 && !line) || c == 0x7f)
            *text = ' ';
        else if (before == 0xc2 && c >= 0x80 && c < 0xa0)
            text[-1] = text[0] = ' ';
        before = c;
    }
}

/* A text attribute, NULL when there is none; notes when memory is out. */
static const char *text_of(ovr_result *r, uint64_t object, const char *name)
{
    const char *found = ovr_container_text(&r->container, object, name);
    char *text = found ? ovr_arena_text(&r->arena, found, NULL) : NULL;
    r->starved = r->starved || (found && !text);
    if (text)
        make_plain(text, strcmp(name, "text") == 0);
    return text;
}

static const char *or_else(const char *text, const char *other)
{
    return text ? text : other;
}

static bool describe(ovr_result *r, uint64_t object, const char *name,
                     ovr_variable *variable)
{
    variable->name = ovr_arena_text(&r->arena, name, NULL);
    r->starved = r->starved || !variable->name;
    variable->long_name = or_else(text_of(r, object, "long_name"),
                                  variable->name);
    variable->unit = or_else(text_of(r, object, "units"), "1");
    variable->scale = ovr_container_number(&r->container, object, "scale");
    return variable->name != NULL;
}

static ovr_status damaged(const ovr_result *r, const char *what, ovr_error *err)
{
    return ovr_fail(err, OVR_IO, "%s: damaged result file: %s", r->path, what);
}

/* A dataset of this rank, described. */
static bool take_variable(ovr_result *r, uint64_t group, const char *name,
                          int rank, ovr_dataset *set, ovr_variable *variable)
{
    uint64_t object;
    return ovr_container_find(&r->container, group, name, &object) &&
           ovr_container_dataset(&r->container, object, set) &&
           set->rank == rank && describe(r, object, name, variable);
}

/* x and time, and the number of rows that both have.  There are no more nodes
 * than positions, and those are in the file. */
static ovr_status open_axes(ovr_result *r, ovr_error *err)
{
    uint64_t root = r->container.root;
    ovr_dataset x, time;
    if (!take_variable(r, root, "x", 1, &x, &r->x) || x.shape[0] == 0 ||
        !take_variable(r, root, "time", 1, &time, &r->time))
        return damaged(r, "no x or no time", err);
    r->info.nodes = (size_t)x.shape[0];
    r->info.snapshots = complete_rows(r, &time, (size_t)time.shape[0]);
    return OVR_OK;
}

static ovr_status open_fields(ovr_result *r, ovr_error *err)
{
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++) {
        ovr_dataset set;
        if (!take_variable(r, r->container.root, ovr_field_table[k].name, 2,
                           &set, &r->field[r->fields]) ||
            set.shape[1] != r->info.nodes)
            continue;
        r->fields++;
        if (set.shape[0] < r->info.snapshots)
            r->info.snapshots = (size_t)set.shape[0];
    }
    return r->fields ? OVR_OK : damaged(r, "no field", err);
}

static void open_column(ovr_result *r, const ovr_link *link)
{
    ovr_dataset set;
    if (!ovr_container_dataset(&r->container, link->object, &set) ||
        set.rank != 1)
        return;
    if (r->columns == 0 || set.shape[0] < r->info.steps)
        r->info.steps = (size_t)set.shape[0];
    if (describe(r, link->object, link->name, &r->column[r->columns]))
        r->columns++;
}

/* Columns that this version does not know are read like the others: a newer
 * one may have written them. */
static ovr_status open_columns(ovr_result *r, uint64_t group, ovr_error *err)
{
    size_t count;
    ovr_link *links = ovr_container_links(&r->container, group, &count);
    if (!links || count > MAX_COLUMNS)
        return damaged(r, "its history", err);
    r->column = ovr_arena_take(&r->arena, count + 1, sizeof *r->column, err);
    if (!r->column)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < count; k++)
        open_column(r, &links[k]);
    return OVR_OK;
}

static ovr_status open_history(ovr_result *r, ovr_error *err)
{
    uint64_t group;
    ovr_dataset time;
    ovr_status status;
    if (!ovr_container_find(&r->container, r->container.root, "history",
                            &group))
        return damaged(r, "no history", err);
    status = open_columns(r, group, err);
    if (status != OVR_OK)
        return status;
    if (!ovr_reader_dataset(r, "history/time", &time) || time.rank != 1)
        return damaged(r, "no time in its history", err);
    r->info.steps = complete_rows(r, &time, r->info.steps);
    return OVR_OK;
}

static double number_of(ovr_result *r, const char *name)
{
    return ovr_container_number(&r->container, r->container.root, name);
}

static void read_attributes(ovr_result *r)
{
    ovr_result_info *i = &r->info;
    uint64_t root = r->container.root, group;
    bool has_case = ovr_container_find(&r->container, root, "case", &group);
    i->title = or_else(text_of(r, root, "title"), "");
    i->status = or_else(text_of(r, root, "status"), "");
    i->reason = or_else(text_of(r, root, "reason"), "");
    i->source = or_else(text_of(r, root, "source"), "");
    i->created = or_else(text_of(r, root, "date_created"), "");
    i->modified = or_else(text_of(r, root, "date_modified"), "");
    i->case_text = has_case ? or_else(text_of(r, group, "text"), "") : "";
    i->physical = strcmp(or_else(text_of(r, root, "scaling"), ""), "SI") == 0;
    i->b = number_of(r, "scale_length");
    i->ph = number_of(r, "scale_pressure");
    i->height = number_of(r, "scale_height");
    i->time = number_of(r, "scale_time");
    i->M = number_of(r, "M");
    i->L = number_of(r, "L");
    i->alphabar = number_of(r, "alphabar");
    i->lambda = number_of(r, "lambda");
    i->u1_ratio = number_of(r, "u1_over_um");
    i->u2_ratio = number_of(r, "u2_over_um");
    i->end = number_of(r, "time_end") / (i->physical ? i->time : 1);
    i->seconds = number_of(r, "date_seconds");
}

static ovr_status not_ours(const ovr_result *r, ovr_error *err)
{
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: an HDF5 file, but not a result of overroll", r->path);
}

static ovr_status check_format(ovr_result *r, ovr_error *err)
{
    double version = number_of(r, "format_version");
    if (isnan(version))
        return not_ours(r, err);
    if (version != OVR_FORMAT_VERSION)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: written in format version %g; this program reads "
                        "version %d",
                        r->path, version, OVR_FORMAT_VERSION);
    return OVR_OK;
}

static bool journal_name(const char *path, char *name, size_t size)
{
    int length = snprintf(name, size, "%s.journal", path);
    return length > 0 && (size_t)length < size;
}

int ovr_reader_enter(const ovr_result *r)
{
    char name[4096];
    int journal = -1;
    if (journal_name(r->path, name, sizeof name))
        journal = open(name, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (journal >= 0)
        ovr_turn_take(journal, false);
    return journal;
}

void ovr_reader_leave(int turn)
{
    if (turn < 0)
        return;
    ovr_turn_give(turn);
    close(turn);
}

static ovr_status cut(const ovr_result *r, ovr_error *err)
{
    return ovr_fail(err, OVR_IO,
                    "%s: its last write was cut; 'overroll resume' repairs it",
                    r->path);
}

/* A file cut in the middle of a commit is a mixture of two states, of which
 * the checksums find only some. */
ovr_status ovr_reader_file(ovr_result *r, int turn, ovr_error *err)
{
    r->fd = open(r->path, O_RDONLY | O_CLOEXEC);
    if (r->fd < 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: %s", r->path, strerror(errno));
    if (turn >= 0 && ovr_journal_pending(turn, r->fd))
        return cut(r, err);
    switch (ovr_container_open(&r->container, r->fd, &r->work)) {
    case OVR_FOUND_CONTAINER: return OVR_OK;
    case OVR_FOUND_OTHER_HDF5: return not_ours(r, err);
    case OVR_FOUND_TRUNCATED:
        return ovr_fail(err, OVR_IO, "%s: a truncated or damaged HDF5 file",
                        r->path);
    case OVR_FOUND_NO_MEMORY:
        return ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory", r->path);
    default:
        return ovr_fail(err, OVR_BAD_INPUT, "%s: not an HDF5 file", r->path);
    }
}

void ovr_reader_close_file(ovr_result *r)
{
    if (r->fd >= 0)
        close(r->fd);
    r->fd = -1;
    ovr_arena_release(&r->work);
}

static ovr_status open_once(ovr_result *r, int turn, ovr_error *err)
{
    ovr_status status = ovr_reader_file(r, turn, err);
    r->fields = r->columns = 0;
    if (status == OVR_OK)
        status = check_format(r, err);
    if (status == OVR_OK)
        status = open_axes(r, err);
    if (status == OVR_OK)
        status = open_fields(r, err);
    if (status == OVR_OK)
        status = open_history(r, err);
    if (status == OVR_OK)
        read_attributes(r);
    if (r->starved || r->container.source.starved)
        status = ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory", r->path);
    ovr_arena_release(&r->work);
    return status;
}

bool ovr_reader_again(const ovr_result *r, int attempt, bool turn)
{
    enum { MOST = 4 };
    struct timespec wait = {0, 1000000L << attempt};
    char journal[4096];
    bool written = turn || (journal_name(r->path, journal, sizeof journal) &&
                            access(journal, F_OK) == 0);
    if (!written || attempt >= MOST)
        return false;
    nanosleep(&wait, NULL);
    return true;
}

static ovr_status open_result(ovr_result *r, ovr_error *err)
{
    ovr_status status;
    int attempt = 0, turn;
    do {
        ovr_reader_close_file(r);
        turn = ovr_reader_enter(r);
        status = open_once(r, turn, err);
        ovr_reader_leave(turn);
    } while (status == OVR_IO && ovr_reader_again(r, attempt++, turn >= 0));
    if (status == OVR_IO && err)
        err->status = OVR_BAD_INPUT;
    return status == OVR_IO ? OVR_BAD_INPUT : status;
}

ovr_result *ovr_result_open(const char *path, const ovr_allocator *allocator,
                            ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_result *r = ovr_arena_take(&arena, 1, sizeof *r, err);
    if (!r)
        return NULL;
    r->arena = arena;
    r->work = ovr_arena_make(allocator);
    r->fd = -1;
    r->path = ovr_arena_text(&r->arena, path, err);
    if (!r->path || open_result(r, err) != OVR_OK) {
        ovr_result_close(r);
        r = NULL;
    }
    return r;
}

void ovr_result_close(ovr_result *r)
{
    ovr_arena arena;
    if (!r)
        return;
    ovr_reader_close_file(r);
    arena = r->arena;
    ovr_arena_release(&arena);
}
