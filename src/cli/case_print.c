/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/case_print.h"

#include <stdio.h>
#include <string.h>

/* ------------------------------------------------------------------- text */

static void put_header(const ovr_case_entry *entry)
{
    if (entry->name)
        printf("\n[%s %s]\n", entry->section, entry->name);
    else
        printf("\n[%s]\n", entry->section);
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

/* The default level does not count beside nodes. */
static bool is_shown(const ovr_case *c, const ovr_case_entry *entry)
{
    if (!entry->text || (!entry->given && !entry->applies))
        return false;
    return entry->given || strcmp(entry->section, "domain") != 0 ||
           strcmp(entry->key, "level") != 0 || !has_nodes(c);
}

void cli_put_case(const ovr_case *c)
{
    const char *section = "", *name = NULL;
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        if (!is_shown(c, &entry))
            continue;
        if (strcmp(section, entry.section) != 0 || name != entry.name)
            put_header(&entry);
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
