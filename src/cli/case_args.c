/* SPDX-License-Identifier: GPL-3.0-or-later */

#include <stdio.h>
#include <string.h>

#include "cli/case_args.h"

/* ----------------------------------------------------------- Opening a case */

static const struct {
    const char *option, *where;
} shorts[] = {
    {"M", "contact.M"},
    {"L", "contact.L"},
    {"level", "domain.level"},
    {"scheme", "time.scheme"},
    {"smoother", "paper.smoother"},
};

/* Removes settings that options replace: --level replaces nodes, --M and --L
 * replace lambda and alphabar. */
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

/* ---------------------------------------------------------- Printing a case */

/* ------------------------------------------------------------------- text */

static void print_header(const ovr_case_entry *entry)
{
    if (entry->name)
        printf("\n[%s %s]\n", entry->section, entry->name);
    else
        printf("\n[%s]\n", entry->section);
}

static bool has_section(const ovr_case *c, const char *name)
{
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        if (entry.given && !strcmp(entry.section, name))
            return true;
    }
    return false;
}

static bool has_nodes(const ovr_case *c)
{
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        if (!strcmp(entry.key, "nodes"))
            return entry.given;
    }
    return false;
}

/* True if the default of this key depends on other keys, or if the key is
 * rejected there. Machine elements determine histories and passes, nodes the
 * level. */
static bool depends(const ovr_case *c, const ovr_case_entry *entry)
{
    const char *section = entry->section;
    if (!strcmp(section, "domain"))
        return !strcmp(entry->key, "level") && has_nodes(c);
    if (!strcmp(section, "output"))
        return !strcmp(entry->key, "fields") ||
               !strcmp(entry->key, "precision");
    if (!strcmp(section, "passes"))
        return !strcmp(entry->key, "number") &&
               has_section(c, "roller_bearing");
    if (strcmp(entry->key, "history") != 0)
        return false;
    return has_section(c, "gear") || has_section(c, "cam") ||
           has_section(c, "roller_bearing");
}

/* True if an entry is printed. */
static bool is_shown(const ovr_case *c, const ovr_case_entry *entry)
{
    return entry->text &&
           (entry->given || (entry->applies && !depends(c, entry)));
}

void cli_put_case(const ovr_case *c)
{
    const char *section = "", *name = NULL;
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        if (!is_shown(c, &entry))
            continue;
        if (strcmp(section, entry.section) != 0 || name != entry.name)
            print_header(&entry);
        section = entry.section;
        name = entry.name;
        printf("%s = %s%s\n", entry.key, entry.text,
               entry.given ? "" : "    # default");
    }
}

/* ------------------------------------------------------------------- JSON */

void cli_json_case(json_writer *json, const ovr_case *c)
{
    json_open_array(json, "parameters");
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        if (!entry.text)
            continue;
        json_open(json, NULL);
        json_text(json, "section", entry.section);
        if (entry.name)
            json_text(json, "name", entry.name);
        json_text(json, "key", entry.key);
        json_text(json, "text", entry.text);
        json_number(json, "value", entry.number);
        json_text(json, "unit", entry.unit);
        json_flag(json, "given", entry.given);
        json_close(json);
    }
    json_close_array(json);
}
