/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/case_args.h"

#include <stdio.h>

static const struct {
    const char *option, *where;
} shorts[] = {
    {"M", "contact.M"},
    {"L", "contact.L"},
    {"level", "domain.level"},
    {"scheme", "time.scheme"},
    {"smoother", "paper.smoother"},
};

/* --level wins over nodes in the file, --M and --L over lambda, alphabar. */
static void remove_overridden(ovr_case *c, const char *option)
{
    if (option[0] == 'l')
        ovr_case_unset(c, "domain.nodes");
}

ovr_status cli_apply_options(const cli_call *call, ovr_case *c, ovr_error *err)
{
    const char *value;
    for (size_t i = 0; i < sizeof shorts / sizeof shorts[0]; i++) {
        char origin[16];
        value = cli_value(call, shorts[i].option);
        if (!value)
            continue;
        snprintf(origin, sizeof origin, "--%s", shorts[i].option);
        remove_overridden(c, shorts[i].option);
        if (ovr_case_set(c, shorts[i].where, value, origin, err))
            return OVR_BAD_INPUT;
    }
    for (int k = 0; (value = cli_value_at(call, "set", k)) != NULL; k++)
        if (ovr_case_assign(c, value, "--set", err))
            return OVR_BAD_INPUT;
    return OVR_OK;
}

ovr_case *cli_open_case(const cli_call *call, int *code)
{
    ovr_error err = {0};
    ovr_case *c = call->arguments ? ovr_case_read(call->argument[0], NULL, &err)
                                  : ovr_case_create(NULL, &err);
    *code = CLI_DONE;
    if (c && cli_apply_options(call, c, &err) == OVR_OK)
        return c;
    *code = cli_fail(&err);
    ovr_case_free(c);
    return NULL;
}
