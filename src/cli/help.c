/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll help [TOPIC]: commands, and what may stand in a case file. */
#include <stdio.h>

#include "cli/cli.h"

static int list_verbs(void)
{
    puts("overroll COMMAND ...: transient rough EHL line contacts\n");
    for (const cli_verb *const *verb = cli_verbs; *verb; verb++)
        printf("  %-9s %-24s %s\n", (*verb)->name, (*verb)->arguments,
               (*verb)->summary);
    puts("\nCommon options: -q quiet, -v say more, --json, --help, --version");
    return CLI_DONE;
}

static int run(cli_call *call)
{
    const cli_verb *verb;
    if (call->arguments == 0)
        return list_verbs();
    verb = cli_find_verb(call->argument[0]);
    if (!verb)
        return cli_usage(call, "no topic '%s'; 'overroll help' lists them",
                         call->argument[0]);
    cli_print_help(verb, stdout);
    return CLI_DONE;
}

const cli_verb cli_help = {
    .name = "help",
    .arguments = "[TOPIC]",
    .summary = "explain a command or a section of the case file",
    .least = 0,
    .most = 1,
    .run = run,
};
