/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lists the contents of a result file and counts its complete rows. */
#include "results/reader.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"

/* Limits, far larger than in any file; groups are nested as in
 * stress/surface_1. */
enum { MAX_VARIABLES = 512, MAX_GROUPS = 32, DEEPEST = 2 };

/* ------------------------------------------------------------- datasets */

bool ovr_reader_object(ovr_result *r, const char *path, uint64_t *object)
{
    ovr_container *c = &r->container;
    char name[64];
    *object = c->root;
    while (*path) {
        size_t length = strcspn(path, "/");
        if (length >= sizeof name)
            return false;
        snprintf(name, sizeof name, "%.*s", (int)length, path);
        if (!ovr_container_find(c, *object, name, object))
            return false;
        path += length + (path[length] == '/');
    }
    return true;
}

bool ovr_reader_dataset(ovr_result *r, const char *path, ovr_dataset *set)
{
    uint64_t object;
    return ovr_reader_object(r, path, &object) &&
           ovr_container_dataset(&r->container, object, set);
}

/* Reduces *rows to the rows before the first NaN, which marks incomplete rows;
 * false if they cannot be read. */
static bool count_complete(ovr_result *r, const ovr_dataset *set, size_t *rows)
{
    ovr_container *c = &r->container;
    size_t low = 0, high = *rows;
    size_t at = *rows ? *rows - 1 : 0; /* usually all rows are complete */
    double value;
    while (low < high) {
        if (!ovr_container_values(c, set, at, 1, &value))
            return false;
        if (isnan(value))
            high = at;
        else
            low = at + 1;
        at = low + (high - low) / 2;
    }
    *rows = low;
    return true;
}

/* -------------------------------------------------------------- opening */

/* True for attributes that may contain line ends: the case and warnings. Other
 * control characters are removed, because texts are printed on terminals. */
static bool has_lines(const char *name)
{
    return strcmp(name, "text") == 0 || strcmp(name, "warnings") == 0;
}

/* Reads a text attribute; records insufficient memory. */
const char *ovr_reader_text(ovr_result *r, uint64_t object, const char *name)
{
    const char *found = ovr_container_text(&r->container, object, name);
    char *text = found ? ovr_escaped(found, has_lines(name), &r->arena) : NULL;
    r->starved = r->starved || (found && !text);
    return text;
}

static const char *or_else(const char *text, const char *other)
{
    return text ? text : other;
}

static ovr_unit_kind kind_of(ovr_result *r, uint64_t object)
{
    const char *kind = ovr_reader_text(r, object, "kind");
    return kind ? ovr_kind_named(kind) : OVR_KIND_NUMBER;
}

static void describe(ovr_result *r, uint64_t object, const char *path,
                     const ovr_dataset *set)
{
    ovr_variable *v = &r->variable[r->variables];
    const char *slash = strrchr(path, '/');
    v->path = ovr_arena_text(&r->arena, path, NULL);
    r->starved = r->starved || !v->path;
    if (!v->path)
        return;
    v->name = slash ? v->path + (slash - path) + 1 : v->path;
    v->long_name = or_else(ovr_reader_text(r, object, "long_name"), v->name);
    v->unit = or_else(ovr_reader_text(r, object, "units"), "1");
    v->scale = ovr_container_number(&r->container, object, "scale");
    v->kind = kind_of(r, object);
    v->rank = set->rank;
    for (int k = 0; k < set->rank; k++)
        v->shape[k] = (size_t)set->shape[k];
    r->set[r->variables++] = *set;
}

static ovr_status damaged(const ovr_result *r, const char *what, ovr_error *err)
{
    return ovr_fail(err, OVR_IO, "%s: damaged result file: %s", r->path, what);
}

/* Lists all numeric datasets of a group and its subgroups in order of creation,
 * including unknown ones, which a newer version may have written. Unreadable
 * objects are skipped. */
static ovr_status list_group(ovr_result *r, uint64_t group, const char *name,
                             int depth, ovr_error *err)
{
    size_t count;
    ovr_link *links = ovr_container_links(&r->container, group, &count);
    ovr_status status = OVR_OK;
    if (!links)
        return damaged(r, *name ? name : "its groups", err);
    for (size_t k = 0; !status && k < count; k++) {
        uint64_t object = links[k].object;
        if (depth == 0 && strcmp(links[k].name, "inputs") == 0)
            continue;
        char path[256];
        ovr_dataset set;
        snprintf(path, sizeof path, "%s%s%s", name, *name ? "/" : "",
                 links[k].name);
        if (ovr_container_dataset(&r->container, object, &set)) {
            if (r->variables == MAX_VARIABLES)
                return damaged(r, "too many variables", err);
            describe(r, object, path, &set);
            continue;
        }
        switch (ovr_container_object(&r->container, object)) {
        case OVR_OBJECT_TEXTS: break;
        case OVR_OBJECT_GROUP:
            if (depth < DEEPEST && r->groups++ < MAX_GROUPS)
                status = list_group(r, object, path, depth + 1, err);
            break;
        default:
            return ovr_fail(err, OVR_IO, "%s: cannot read '%s'", r->path, path);
        }
    }
    return status;
}

static ovr_status list_variables(ovr_result *r, ovr_error *err)
{
    ovr_arena *a = &r->arena;
    if (!r->variable) {
        r->variable = ovr_arena_take(a, MAX_VARIABLES, sizeof *r->variable,
                                     err);
        r->set = ovr_arena_take(a, MAX_VARIABLES, sizeof *r->set, err);
        r->field = ovr_arena_take(a, MAX_VARIABLES, sizeof *r->field, err);
        r->column = ovr_arena_take(a, MAX_VARIABLES, sizeof *r->column, err);
    }
    if (ovr_arena_status(a))
        return OVR_NO_MEMORY;
    r->variables = r->fields = r->columns = r->groups = 0;
    r->sets_hold = true;
    return list_group(r, r->container.root, "", 0, err);
}

const ovr_variable *ovr_result_find(const ovr_result *r, const char *path)
{
    if (!r || !path)
        return NULL;
    for (size_t k = 0; k < r->variables; k++)
        if (strcmp(r->variable[k].path, path) == 0)
            return &r->variable[k];
    return NULL;
}

/* Reads the lines of a strip and the line shown by default. */
static bool open_lines(ovr_result *r)
{
    double shown = ovr_container_number(&r->container, r->container.root,
                                        "shown_line");
    ovr_dataset y;
    r->y = ovr_result_find(r, "y");
    if (!r->y || !ovr_reader_dataset(r, "y", &y) || y.rank != 1 ||
        y.shape[0] == 0)
        return false;
    r->info.lines = (size_t)y.shape[0];
    r->shown = shown >= 0 && shown < (double)r->info.lines ? (size_t)shown : 0;
    return true;
}

/* Reads x and time and their number of complete rows. There are as many nodes
 * as positions in the file. */
static ovr_status open_axes(ovr_result *r, ovr_error *err)
{
    ovr_dataset x, time;
    r->x = ovr_result_find(r, "x");
    r->time = ovr_result_find(r, "time");
    if (!r->x || !r->time || !ovr_reader_dataset(r, "x", &x) ||
        !ovr_reader_dataset(r, "time", &time) || x.rank != 1 ||
        x.shape[0] == 0 || time.rank != 1)
        return damaged(r, "no x or no time", err);
    r->info.nodes = (size_t)x.shape[0];
    r->info.lines = 1;
    if (r->version == OVR_FORMAT_STRIP && !open_lines(r))
        return damaged(r, "no y", err);
    r->info.snapshots = (size_t)time.shape[0];
    if (!count_complete(r, &time, &r->info.snapshots))
        return damaged(r, "its time", err);
    return OVR_OK;
}

static void minimum(size_t *count, size_t rows)
{
    if (rows < *count)
        *count = rows;
}

/* Separates fields along x from history columns; computes their common number
 * of rows. */
static void sort_variables(ovr_result *r)
{
    static const char history[] = "history/";
    r->info.steps = SIZE_MAX;
    for (size_t k = 0; k < r->variables; k++) {
        const ovr_variable *v = &r->variable[k];
        bool strip = r->info.lines > 1;
        if (v->name == v->path && v->rank == (strip ? 3 : 2) &&
            v->shape[v->rank - 1] == r->info.nodes &&
            (!strip || v->shape[1] == r->info.lines)) {
            minimum(&r->info.snapshots, v->shape[0]);
            r->field[r->fields++] = v;
        } else if (v->rank == 1 && v->name == v->path + strlen(history) &&
                   strncmp(v->path, history, strlen(history)) == 0) {
            minimum(&r->info.steps, v->shape[0]);
            r->column[r->columns++] = v;
        }
    }
}

static ovr_status open_lists(ovr_result *r, ovr_error *err)
{
    ovr_dataset time;
    sort_variables(r);
    if (!r->fields)
        return damaged(r, "no field", err);
    if (!ovr_reader_dataset(r, "history/time", &time) || time.rank != 1)
        return damaged(r, "no time in its history", err);
    if (!count_complete(r, &time, &r->info.steps))
        return damaged(r, "the time of its history", err);
    for (size_t k = 0; k < r->variables; k++)
        if (r->variable[k].path == r->time->path ||
            (r->variable[k].name == r->variable[k].path &&
             r->variable[k].rank > 1))
            minimum(&r->variable[k].shape[0], r->info.snapshots);
        else if (strncmp(r->variable[k].path, "history/", 8) == 0)
            minimum(&r->variable[k].shape[0], r->info.steps);
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
    i->title = or_else(ovr_reader_text(r, root, "title"), "");
    i->status = or_else(ovr_reader_text(r, root, "status"), "");
    i->reason = or_else(ovr_reader_text(r, root, "reason"), "");
    i->warnings = or_else(ovr_reader_text(r, root, "warnings"), "");
    i->source = or_else(ovr_reader_text(r, root, "source"), "");
    i->created = or_else(ovr_reader_text(r, root, "date_created"), "");
    i->modified = or_else(ovr_reader_text(r, root, "date_modified"), "");
    i->case_text = has_case ? or_else(ovr_reader_text(r, group, "text"), "")
                            : "";
    i->physical = strcmp(or_else(ovr_reader_text(r, root, "scaling"), ""),
                         "SI") == 0;
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
    i->width = r->info.lines > 1 ? number_of(r, "strip_width_over_b") : 0;
}

ovr_status ovr_reader_not_ours(ovr_result *r, ovr_error *err)
{
    ovr_dataset pass;
    if (ovr_reader_dataset(r, "pass", &pass))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: contains one row per pass; the results of the "
                        "passes are in separate files, which 'overroll info' "
                        "lists",
                        r->path);
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: is an HDF5 file, but not a result of overroll",
                    r->path);
}

static ovr_status check_format(ovr_result *r, ovr_error *err)
{
    r->version = number_of(r, "format_version");
    if (isnan(r->version))
        return ovr_reader_not_ours(r, err);
    if (r->version != OVR_FORMAT_VERSION && r->version != OVR_FORMAT_STRIP)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: has format version %g, but this program reads "
                        "versions %d and %d",
                        r->path, r->version, OVR_FORMAT_VERSION,
                        OVR_FORMAT_STRIP);
    return OVR_OK;
}

ovr_status ovr_reader_content(ovr_result *r, ovr_error *err)
{
    ovr_status status = check_format(r, err);
    if (status == OVR_OK)
        status = list_variables(r, err);
    if (status == OVR_OK)
        status = open_axes(r, err);
    if (status == OVR_OK)
        status = open_lists(r, err);
    if (status == OVR_OK)
        read_attributes(r);
    return status == OVR_OK ? ovr_reader_inputs(r, err) : status;
}
