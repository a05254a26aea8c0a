/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of several passes that people read has the columns whose rows give
 * them a place there, from left to right. */
#include <string.h>

#include "overroll/run.h"
#include "run/pass_columns.h"

static const ovr_table_column *named(const ovr_table *t, const char *name)
{
    const ovr_table_column *c;
    for (size_t k = 0; (c = ovr_table_at(t, k)); k++)
        if (strcmp(c->name, name) == 0)
            break;
    return c;
}

/* True if columns that need this physics are in the table; 0: none is needed.
 */
static bool is_in(const ovr_table *t, unsigned physics)
{
    ovr_pass_column c;
    bool in = !physics;
    for (size_t k = 0; !in && ovr_pass_column_at(k, &c); k++)
        in = c.of && c.of->needs & physics && named(t, c.name);
    return in;
}

bool ovr_table_pass_head(const ovr_table *table, size_t k, ovr_pass_head *to)
{
    ovr_pass_column c;
    int last = 1;
    if (!table || !to)
        return false;
    for (int place = 1; place <= last; place++)
        for (size_t i = 0; ovr_pass_column_at(i, &c); i++) {
            if (c.place > last)
                last = c.place;
            if (c.place != place || !is_in(table, c.with) || k-- > 0)
                continue;
            *to = (ovr_pass_head){c.head, named(table, c.name)};
            return true;
        }
    return false;
}
