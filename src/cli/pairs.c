/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll help pairs: what does not go together, and why. */
#include <stdio.h>

#include "cli/cli.h"

/* "[domain] order"; of a section that is there or not, its name. */
static void place(int part, size_t size, char *text)
{
    ovr_part_info info = ovr_part_at(part);
    snprintf(text, size, "[%s]%s%s", info.section, info.whole ? "" : " ",
             info.whole ? "" : info.key);
}

static void put_refusals(bool roff)
{
    const ovr_refusal *r;
    for (size_t k = 0; (r = ovr_refusal_at(k)); k++) {
        char where[40];
        place(r->part, sizeof where, where);
        printf(roff ? ".TP\n.B %s beside %s\n%s must be %s: %s.\n"
                    : "  %s beside %s\n        %s: %s\n        since %s\n",
               ovr_part_at(r->part).name, ovr_part_at(r->beside).name, where,
               r->instead, r->why);
    }
}

int cli_help_pairs(void)
{
    puts("What does not go together is refused before anything is solved. "
         "Every other\npair works; what is not written gives way by itself.\n");
    put_refusals(false);
    return CLI_DONE;
}

void cli_roff_pairs(void)
{
    puts(".SH WHAT GOES WITH WHAT\n"
         "Every two parts of a case work together but for these, which are "
         "refused\nbefore anything is solved where both are written; what is "
         "not written gives\nway.");
    put_refusals(true);
}
