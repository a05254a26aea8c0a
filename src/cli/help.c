/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll help [TOPIC]: the commands, and the keys of a case file.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "cli/cli.h"

/* Writes the name of a model feature, "[domain] order", or of its section. */
static void place(int feature, size_t size, char *text)
{
    ovr_model_feature_info info = ovr_model_feature_at(feature);
    snprintf(text, size, "[%s]%s%s", info.section, info.whole ? "" : " ",
             info.whole ? "" : info.key);
}

static void print_conflict_rows(bool roff)
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

static int print_conflicts(void)
{
    puts("The following combinations are rejected before anything is solved.  "
         "Every other\npair works; defaults adapt automatically.\n");
    print_conflict_rows(false);
    return CLI_DONE;
}

static void print_roff_conflicts(void)
{
    puts(".SH COMBINATIONS\n"
         "Any two features of a case can be combined, except the following.  "
         "They are\nrejected before anything is solved if the case sets both; "
         "defaults adapt\nautomatically.");
    print_conflict_rows(true);
}

/* --------------------------------------------------------------------- Help */

enum { WIDTH = 78, INDENT = 17, TOPICS = 1000, KEYS = 1000 };

/* ------------------------------------------------------------------ Lists */

static void print_wrapped(const char *text)
{
    int column = INDENT;
    printf("%*s", INDENT, "");
    while (*text) {
        int length = (int)strcspn(text, " ");
        if (column > INDENT && column + 1 + length > WIDTH) {
            printf("\n%*s", INDENT, "");
            column = INDENT;
        } else if (column > INDENT) {
            putchar(' ');
            column++;
        }
        printf("%.*s", length, text);
        column += length;
        text += length + (text[length] == ' ');
    }
    putchar('\n');
}

static int list_topics(const cli_call *call)
{
    puts("overroll COMMAND ...: transient rough EHL line contacts\n");
    for (const cli_verb *const *verb = call->verbs; *verb; verb++)
        printf("  %-9s %-26s %s\n", (*verb)->name, (*verb)->arguments,
               (*verb)->summary);
    puts("\nCommon options: -q (--quiet), -v (--verbose), --json, -h (--help), "
         "--version\n"
         "\nSections of a case file (overroll help SECTION lists its keys):\n");
    for (size_t k = 0; ovr_section_name(k); k++) {
        printf("  %s\n", ovr_section_name(k));
        print_wrapped(ovr_section_help(k));
    }
    puts("\noverroll help units      how numbers and units are written\n"
         "overroll help conflicts  combinations that are rejected, and why\n"
         "overroll help KEY        one key of the case file\n"
         "overroll help SHAPE      a shape of feature: the keys that it needs\n"
         "overroll help TERM       a usual term or symbol: SRR, E, Rq, film "
         "thickness ...\n");
    printf("Other topics:");
    for (size_t k = 0; cli_topic_name(k); k++)
        printf("%s %s", k ? "," : "", cli_topic_name(k));
    puts(".");
    return CLI_DONE;
}

/* ------------------------------------------------------------- Parameters */

static void describe_range(const ovr_parameter_info *p, char *text,
                           size_t capacity)
{
    const char *unit = p->limit_unit;
    snprintf(text, capacity, "%s%s%g to %g%s%s", p->type,
             p->above ? " above " : " ", p->minimum / p->limit_value,
             p->maximum / p->limit_value, *unit ? " " : "", unit);
}

static void print_choices(const ovr_parameter_info *p)
{
    char text[400];
    cli_join(p->choices, sizeof p->choices / sizeof *p->choices, text,
             sizeof text);
    print_wrapped(text);
}

/* Describes the width of a feature: the width of each shape at half its
 * height. */
static void describe_widths(const ovr_parameter_info *p, char *text,
                            size_t capacity)
{
    size_t used = 0;
    text[0] = '\0';
    if (strcmp(p->section, "feature") != 0 || strcmp(p->key, "width") != 0)
        return;
    used = (size_t)snprintf(text, capacity, "width_half over width:");
    for (int k = 0; ovr_shape_name(k) && used < capacity; k++)
        if (isfinite(ovr_shape_width_half(k)))
            used += (size_t)snprintf(text + used, capacity - used, "%s %s %.4g",
                                     strchr(text, '.') ? "," : "",
                                     ovr_shape_name(k),
                                     ovr_shape_width_half(k));
}

static void print_parameter(const ovr_parameter_info *p)
{
    char text[300];
    printf("  %-14s ", p->key);
    if (p->initial)
        printf("(%s)", p->initial);
    putchar('\n');
    print_wrapped(p->help);
    describe_widths(p, text, sizeof text);
    if (*text)
        print_wrapped(text);
    if (!isnan(p->minimum)) {
        describe_range(p, text, sizeof text);
        print_wrapped(text);
    } else if (!p->choices[0]) {
        print_wrapped(p->type);
    }
    if (p->choices[0])
        print_choices(p);
    if (*p->units) {
        snprintf(text, sizeof text, "%s: %s",
                 *p->bare ? "or with a unit" : "unit", p->units);
        print_wrapped(text);
    }
    if (*p->when) {
        snprintf(text, sizeof text, "has an effect with %s", p->when);
        print_wrapped(text);
    }
}

static bool help_section(const char *name)
{
    bool found = false;
    for (size_t k = 0; ovr_section_name(k); k++)
        if (!strcmp(ovr_section_name(k), name)) {
            printf("[%s]  %s\n\nKeys (defaults in brackets):\n\n", name,
                   ovr_section_help(k));
            found = true;
        }
    for (size_t k = 0; found && k < ovr_parameter_count(); k++) {
        ovr_parameter_info p = ovr_parameter_at(k);
        if (!strcmp(p.section, name))
            print_parameter(&p);
    }
    return found;
}

/* Prints the keys that the features of a shape have and others have not; false
 * if there is no such shape. */
static bool help_shape(const char *shape)
{
    char text[500];
    int k = 0;
    while (ovr_shape_name(k) && strcmp(ovr_shape_name(k), shape) != 0)
        k++;
    if (!ovr_shape_name(k))
        return false;
    ovr_shape_takes(k, text, sizeof text);
    printf("[feature NAME]\nshape = %s\n", shape);
    print_wrapped(text);
    putchar('\n');
    for (size_t i = 0; i < ovr_parameter_count(); i++) {
        ovr_parameter_info p = ovr_parameter_at(i);
        const char *at = strncmp(p.when, "shape = ", 8) ? NULL
                                                        : strstr(p.when, shape);
        if (strcmp(p.section, "feature") != 0 || !at ||
            (at[strlen(shape)] && !strchr(", ", at[strlen(shape)])) ||
            at[-1] != ' ')
            continue;
        printf("  %s\n", p.key);
        print_wrapped(p.help);
    }
    return true;
}

static bool help_key(const char *key)
{
    bool found = false;
    const char *point = strchr(key, '.');
    for (size_t k = 0; k < ovr_parameter_count(); k++) {
        ovr_parameter_info p = ovr_parameter_at(k);
        size_t section = strlen(p.section);
        bool same = point ? !strncmp(p.section, key, section) &&
                                key[section] == '.' && !strcmp(p.key, point + 1)
                          : !strcmp(p.key, key);
        if (!same)
            continue;
        printf("[%s]\n", p.section);
        print_parameter(&p);
        found = true;
    }
    return found;
}

/* ------------------------------------------------------------ Manual page */

/* Prints text with the special characters of roff escaped. */
static void print_roff(const char *text)
{
    for (; *text; text++)
        if (*text == '-')
            fputs("\\-", stdout);
        else if (*text == '\'')
            fputs("\\(aq", stdout);
        else
            putchar(*text);
}

static void roff_parameter(const ovr_parameter_info *p)
{
    char text[300];
    printf(".TP\n.B ");
    print_roff(p->key);
    putchar('\n');
    print_roff(p->help);
    puts(".");
    describe_widths(p, text, sizeof text);
    if (*text)
        printf("%s.\n", text);
    if (!isnan(p->minimum)) {
        describe_range(p, text, sizeof text);
        printf("A ");
        print_roff(text);
        puts(".");
    } else if (!p->choices[0]) {
        printf("A value: %s.\n", p->type);
    }
    if (p->choices[0])
        puts(isnan(p->minimum) ? "One of" : "Or");
    for (int i = 0; p->choices[i]; i++) {
        printf(".BR ");
        print_roff(p->choices[i]);
        puts(p->choices[i + 1] ? " ," : " .");
    }
    if (*p->units)
        printf("%s: %s.\n", *p->bare ? "Or with a unit" : "Unit", p->units);
    if (p->initial) {
        printf("Default: ");
        print_roff(p->initial);
        puts(".");
    }
    if (*p->when) {
        printf("Has an effect with ");
        print_roff(p->when);
        puts(".");
    }
}

static void roff_shape(int shape)
{
    char text[500];
    ovr_shape_takes(shape, text, sizeof text);
    printf(".TP\n.B %s\n", ovr_shape_name(shape));
    print_roff(text);
    puts(".");
}

/* Compares keys of parameters for sorting. */
static int by_key(const void *a, const void *b)
{
    ovr_parameter_info x = ovr_parameter_at(*(const size_t *)a);
    ovr_parameter_info y = ovr_parameter_at(*(const size_t *)b);
    int order = strcasecmp(x.key, y.key);
    return order ? order : strcmp(x.key, y.key);
}

/* Prints an index of all keys with their sections, one paragraph per letter. */
static void roff_index(void)
{
    size_t count = 0, number[KEYS] = {0};
    for (; count < ovr_parameter_count() && count < KEYS; count++)
        number[count] = count;
    qsort(number, count, sizeof *number, by_key);
    puts(".SS Index of keys");
    const char *before = "";
    for (size_t k = 0; k < count; k++) {
        ovr_parameter_info p = ovr_parameter_at(number[k]);
        bool again = !strcmp(p.key, before);
        if (tolower(p.key[0]) != tolower(*before))
            puts(".PP");
        fputs(again ? "" : ".B ", stdout);
        print_roff(again ? "" : p.key);
        printf("%s[%s]\n", again ? "" : "\n", p.section);
        before = p.key;
    }
}

/* Prints the part of overroll-case(5) that is generated from the table. */
static int roff(void)
{
    roff_index();
    for (size_t k = 0; ovr_section_name(k); k++) {
        printf(".SS [%s]\n", ovr_section_name(k));
        print_roff(ovr_section_help(k));
        puts(".");
        for (int i = 0;
             !strcmp(ovr_section_name(k), "feature") && ovr_shape_name(i); i++)
            roff_shape(i);
        for (size_t i = 0; i < ovr_parameter_count(); i++) {
            ovr_parameter_info p = ovr_parameter_at(i);
            if (!strcmp(p.section, ovr_section_name(k)))
                roff_parameter(&p);
        }
    }
    print_roff_conflicts();
    return CLI_DONE;
}

/* Prints the part of overroll.bash that is generated from the tables. */
static int bash(const cli_call *call)
{
    for (const cli_verb *const *verb = call->verbs; *verb; verb++) {
        const cli_option *option = (*verb)->options;
        printf("    %s) echo '", (*verb)->name);
        for (; option && option->name; option++) {
            bool letter = option->name[1] == '\0' && option->name[0] >= 'a';
            printf("%s%s ", letter ? "-" : "--", option->name);
        }
        printf("-q -v %s--help' ;;\n", (*verb)->no_json ? "" : "--json ");
    }
    return CLI_DONE;
}

/* Prints the keys for --set, each with its words. */
static int bash_keys(void)
{
    for (size_t i = 0; i < ovr_parameter_count(); i++) {
        ovr_parameter_info p = ovr_parameter_at(i);
        bool flag = !strcmp(p.type, "yes or no");
        printf("    %s.%s) echo '", p.section, p.key);
        for (int k = 0; p.choices[k]; k++)
            printf("%s%s", k ? " " : "", p.choices[k]);
        puts(flag ? "yes no' ;;" : "' ;;");
    }
    return CLI_DONE;
}

/* ------------------------------------------------------------------ Topics */

/* Lists all names that help explains: commands, sections, topics, shapes,
 * keys. */
static size_t list_names(const cli_call *call, const char *names[TOPICS])
{
    size_t n = 0;
    for (const cli_verb *const *verb = call->verbs; *verb; verb++)
        names[n++] = (*verb)->name;
    for (size_t k = 0; ovr_section_name(k); k++)
        names[n++] = ovr_section_name(k);
    for (size_t k = 0; cli_topic_name(k); k++)
        names[n++] = cli_topic_name(k);
    for (int k = 0; ovr_shape_name(k); k++)
        names[n++] = ovr_shape_name(k);
    for (size_t k = 0; k < ovr_parameter_count() && n < TOPICS; k++)
        names[n++] = ovr_parameter_at(k).key;
    return n;
}

/* Prints the help of this exact name; false if there is none. */
static bool help_name(const cli_call *call, const char *name)
{
    const cli_verb *verb = cli_find_verb(call->verbs, name);
    bool found;
    if (verb)
        cli_print_help(verb, stdout);
    else if (!strcmp(name, "units"))
        cli_help_units();
    else if (!strcmp(name, "conflicts") || !strcmp(name, "pairs"))
        print_conflicts();
    else if (!help_section(name)) {
        found = cli_help_topic(name);
        if (found)
            putchar('\n');
        return help_shape(name) || found || help_key(name);
    }
    return true;
}

/* Prints the help of the name that a synonym, a symbol or another spelling
 * stands for. */
static bool help_synonym(const cli_call *call, const char *term)
{
    const char *names[TOPICS], *topic = ovr_parameter_by_symbol(term);
    size_t n = list_names(call, names);
    if (!topic)
        topic = cli_synonym(term);
    for (size_t k = 0; !topic && k < n; k++)
        if (cli_same_term(names[k], term))
            topic = names[k];
    if (!topic)
        return false;
    if (!cli_same_term(topic, term))
        printf("%s: see %s\n\n", term, topic);
    return help_name(call, topic);
}

/* Prints the help of the keys of which `word` is a value, such as "eyring". */
static bool help_value(const char *word)
{
    bool found = false;
    for (size_t k = 0; k < ovr_parameter_count(); k++) {
        ovr_parameter_info p = ovr_parameter_at(k);
        for (int i = 0; p.choices[i]; i++)
            if (cli_same_term(p.choices[i], word)) {
                printf("%s%s: a value of %s.%s\n\n[%s]\n", found ? "\n" : "",
                       p.choices[i], p.section, p.key, p.section);
                print_parameter(&p);
                found = true;
            }
    }
    return found;
}

static int no_topic(const cli_call *call, const char *topic)
{
    const char *names[TOPICS];
    const char *meant = ovr_suggest(topic, names, list_names(call, names));
    if (meant)
        return cli_usage(call, "no topic '%s'; did you mean '%s'?", topic,
                         meant);
    return cli_usage(call, "no topic '%s'; 'overroll help' lists them", topic);
}

static int run(cli_call *call)
{
    char topic[80] = "";
    size_t used = 0;
    for (int k = 0; k < call->arguments && used < sizeof topic; k++)
        used += (size_t)snprintf(topic + used, sizeof topic - used, "%s%s",
                                 k ? " " : "", call->argument[k]);
    if (cli_flag(call, "roff"))
        return roff();
    if (cli_flag(call, "bash"))
        return !strcmp(topic, "keys") ? bash_keys() : bash(call);
    if (call->arguments == 0)
        return list_topics(call);
    const char *also = cli_synonym(topic);
    if (!help_name(call, topic)) {
        if (!help_synonym(call, topic) && !help_value(topic))
            return no_topic(call, topic);
    } else if (also && !cli_same_term(also, topic)) {
        printf("\nSee also: overroll help %s\n", also);
    }
    return CLI_DONE;
}

static const cli_option options[] = {
    {"roff", NULL, "print the parameters in the form of overroll-case(5)",
     false},
    {"bash", NULL, "print the options (or keys) for bash completion", false},
    {0}};

const cli_verb cli_help = {
    .name = "help",
    .no_json = true,
    .arguments = "[TOPIC]",
    .summary = "explain a command, a section or a key of the case",
    .options = options,
    .minimum = 0,
    .maximum = 4,
    .run = run,
};
