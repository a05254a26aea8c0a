/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/columns.h"
#include "base/error.h"

#include <stdio.h>
#include <string.h>

/* ---------------------------------------------------------------- columns */

static int column_named(const ovr_text_table *t, char axis)
{
    for (size_t k = 0; k < t->header.columns; k++)
        if (t->header.column[k].axis == axis)
            return (int)k;
    return -1;
}

static ovr_status requested_column(const ovr_text_table *t, int asked,
                                   const char *key, int *column, ovr_error *err)
{
    if (asked < 0 || (size_t)asked > t->header.columns)
        return ovr_about(
            err, key,
            ovr_fail_at(err, OVR_BAD_INPUT, t->profile->file, 0,
                        "%s = %d: the table has the columns 1 to %zu",
                        ovr_named(t->profile, key).text, asked,
                        t->header.columns));
    if (asked > 0)
        *column = asked - 1;
    return OVR_OK;
}

static bool spaced(const ovr_text_table *t)
{
    return t->source->spacing > 0 || t->header.spacing > 0;
}

/* Finds the columns of x and z by name, by position, or from the caller's
 * options. A column that is still -1 is unknown, or is replaced by a
 * spacing. */
ovr_status ovr_find_columns(ovr_text_table *t, ovr_error *err)
{
    const ovr_profile_source *s = t->source;
    size_t columns = t->header.columns;
    t->x = column_named(t, 'x');
    t->valid = column_named(t, 'v');
    t->z = column_named(t, 'z') >= 0 ? column_named(t, 'z')
                                     : column_named(t, 'y');
    if (columns == 1)
        t->x = -1, t->z = 0;
    if (columns == 2 && (t->x < 0 || t->z < 0 || t->x == t->z))
        t->x = 0, t->z = 1;
    if (requested_column(t, s->column_x, "column_x", &t->x, err) ||
        requested_column(t, s->column_z, "column_z", &t->z, err))
        return OVR_BAD_INPUT;
    if (s->spacing > 0 && !s->column_x)
        t->x = -1;
    if (t->x >= 0 && t->x == t->z)
        return ovr_fail_at(err, OVR_BAD_INPUT, t->profile->file, 0,
                           "x and z must be different columns");
    return OVR_OK;
}

/* ---------------------------------------------------- missing information */

typedef struct wanting {
    const ovr_text_table *t;
    char what[300], give[200]; /* missing information ("no unit of x") and its
                                  remedy ("--unit-x um") */
    const char *about;         /* the first key */
    int count;
} wanting;

static void join(char *text, size_t capacity, const char *between,
                 const char *more)
{
    size_t used = strlen(text);
    snprintf(text + used, capacity - used, "%s%s", used ? between : "", more);
}

static void require(wanting *w, const char *what, const char *key,
                    const char *example)
{
    char give[80];
    bool options = w->t->profile->options;
    snprintf(give, sizeof give, "%s%s%s", ovr_named(w->t->profile, key).text,
             options ? " " : " = ", example);
    join(w->what, sizeof w->what, "; ", what);
    join(w->give, sizeof w->give, ", ", give);
    if (!w->count++)
        w->about = key;
}

static void require_columns(wanting *w)
{
    const ovr_text_table *t = w->t;
    if (t->header.columns == 1) {
        if (!spaced(t))
            require(w, "one column of heights needs a spacing", "spacing",
                    t->profile->options ? "'0.5 um'" : "0.5 um");
        return;
    }
    if (t->x < 0 && !spaced(t))
        require(w, "the header does not specify the column of x", "column_x",
                t->z == 0 ? "2" : "1");
    if (t->z < 0)
        require(w, "the header does not specify the column of the heights",
                "column_z", t->x == 1 ? "1" : "2");
    if (t->x < 0 && t->z < 0 && t->header.columns > 2)
        require(w, "if they are rows of a map", "row", "1");
}

/* Returns the column of the axis; if it is unknown, a column with a unit, or
 * none. */
static const ovr_column *unit_column(const ovr_text_table *t, char axis)
{
    int column = axis == 'x' ? t->x : t->z;
    if (column >= 0)
        return &t->header.column[column];
    for (size_t k = 0; k < t->header.columns; k++)
        if (t->header.column[k].metres > 0)
            return &t->header.column[k];
    return &t->header.column[0];
}

static const char *own_unit(char axis)
{
    return axis == 'x' ? "b" : "b^2/R";
}

double ovr_unit_given(char axis, const char *asked, bool *scaled)
{
    *scaled = strcmp(asked, own_unit(axis)) == 0 ||
              (axis == 'z' && strcmp(asked, "b2/R") == 0);
    return *scaled ? 1
                   : ovr_length_unit((ovr_line){asked, strlen(asked), 0}, true);
}

static bool is_said(const char *asked)
{
    return asked && *asked;
}

static void require_unit(wanting *w, char axis, const char *asked)
{
    const ovr_column *said = unit_column(w->t, axis);
    char what[160];
    bool scaled;
    if (is_said(asked)) {
        if (ovr_unit_given(axis, asked, &scaled) > 0)
            return;
        snprintf(what, sizeof what, "unknown unit '%.40s' of %c", asked, axis);
    } else if (said->metres > 0) {
        return;
    } else if (said->unknown.size) {
        snprintf(what, sizeof what, "unknown unit '%s' of %c in the header",
                 ovr_quote(said->unknown).text, axis);
    } else {
        snprintf(what, sizeof what, "the unit of %c is not in the header",
                 axis);
    }
    require(w, what, axis == 'x' ? "unit_x" : "unit_z", "um");
}

/* True if a unit of x is required: for a column x, or a spacing without a unit
 * in the header. */
static bool needs_unit_x(const ovr_text_table *t)
{
    if (t->source->spacing > 0 && !t->source->column_x)
        return false;
    return t->x >= 0 || t->header.columns > 1 ||
           (t->header.spacing > 0 && !(t->header.spacing_metres > 0));
}

ovr_status ovr_check_given(const ovr_text_table *t, ovr_error *err)
{
    wanting w = {.t = t};
    require_columns(&w);
    if (needs_unit_x(t))
        require_unit(&w, 'x', t->source->unit_x);
    require_unit(&w, 'z', t->source->unit_z);
    if (!w.count)
        return OVR_OK;
    return ovr_about(err, w.about,
                     ovr_fail_at(err, OVR_BAD_INPUT, t->profile->file, 0,
                                 "%s: give %s%s", w.what, w.give,
                                 strstr(w.give, "unit")
                                     ? " (or m, mm, nm, inch, b, ...)"
                                     : ""));
}

void ovr_find_unit(ovr_text_table *t, char axis, const char *asked,
                   double *metres, bool *scaled)
{
    ovr_profile *p = t->profile;
    const ovr_column *said = unit_column(t, axis);
    char key[] = {'u', 'n', 'i', 't', '_', axis, 0};
    if (is_said(asked)) {
        *metres = ovr_unit_given(axis, asked, scaled);
        ovr_profile_note(p, "%c in %s (%s)", axis, asked,
                         ovr_named(p, key).text);
        return;
    }
    *metres = said->metres;
    *scaled = said->scaled;
    ovr_profile_note(p, "%c in %s (header: \"%s\")", axis,
                     *scaled ? own_unit(axis) : ovr_length_unit_name(*metres),
                     ovr_quote(said->from).text);
}
