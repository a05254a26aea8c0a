/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll help conflicts: what does not go together, and why. */
#include <stdio.h>

#include "cli/cli.h"

/* "[domain] order"; of a section that is there or not, its name. */
static void place(int feature, size_t size, char *text)
{
    ovr_model_feature_info info = ovr_model_feature_at(feature);
    snprintf(text, size, "[%s]%s%s", info.section, info.whole ? "" : " ",
             info.whole ? "" : info.key);
}

static void put_conflicts(bool roff)
{
    const ovr_conflict *r;
    for (size_t k = 0; (r = ovr_conflict_at(k)); k++) {
        char where[40];
        place(r->feature, sizeof where, where);
        printf(roff ? ".TP\n.B %s with %s\n%s must be %s: %s.\n"
                    : "  %s with %s\n        %s: %s\n        since %s\n",
               ovr_model_feature_at(r->feature).name,
               ovr_model_feature_at(r->other).name, where, r->instead, r->why);
    }
}

int cli_help_conflicts(void)
{
    puts("What does not go together is refused before anything is solved. "
         "Every other\npair works; what is not written gives way by itself.\n");
    put_conflicts(false);
    return CLI_DONE;
}

void cli_roff_conflicts(void)
{
    puts(".SH WHAT GOES WITH WHAT\n"
         "Every two features of a case work together but for these, which are "
         "refused\nbefore anything is solved where both are written; what is "
         "not written gives\nway.");
    put_conflicts(true);
}
