/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses command lines by a command's table of options; prints messages and
 * help. */
#include "cli/cli.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

static const cli_option common[] = {
    {"q", NULL,
     "print errors only: no messages, no progress, no report of a run "
     "(--quiet)",
     false},
    {"v", NULL, "print more (--verbose)", false},
    {"json", NULL, "results as one JSON object", false},
    {"help", NULL, "print this help (-h)", false},
    {NULL, NULL, NULL, false},
};

/* -------------------------------------------------------------- messages */

void cli_say(void *data, ovr_message_kind kind, const char *text)
{
    const cli_call *call = data;
    if (call->verbosity >= 0)
        fprintf(stderr, "overroll: %s%s\n",
                kind == OVR_MESSAGE_WARNING ? "warning: " : "", text);
}

/* True if a message begins with the name of a file, option or key. */
static bool has_origin(const ovr_error *err)
{
    return err->file || !memchr(err->message, ' ', strcspn(err->message, ":"));
}

int cli_fail(const ovr_error *err)
{
    fprintf(stderr, "%s%s\n",
            has_origin(err) ? "" : "overroll: ", err->message);
    switch (err->status) {
    case OVR_OK: return CLI_DONE;
    case OVR_BAD_INPUT: return CLI_USAGE;
    case OVR_STOPPED: return CLI_EARLY;
    default: return CLI_FAILED;
    }
}

/* Bytes of the control character at the start of s.  C1 controls (U+0080 to
 * U+009F) have two bytes in UTF-8.  0: no control character. */
static int control_bytes(const char *s)
{
    unsigned char c = (unsigned char)s[0], next = c ? (unsigned char)s[1] : 0;
    if ((c > 0 && c < 0x20) || c == 0x7f)
        return 1;
    return c == 0xc2 && next >= 0x80 && next < 0xa0 ? 2 : 0;
}

cli_unit cli_choose_unit(const char *si, double size)
{
    static const struct {
        const char *si;
        cli_unit of;
    } units[] = {
        {"m", {"m", 1}},    {"m", {"mm", 1e3}},    {"m", {"um", 1e6}},
        {"m", {"nm", 1e9}}, {"Pa", {"GPa", 1e-9}}, {"Pa", {"MPa", 1e-6}},
        {"s", {"s", 1}},    {"s", {"ms", 1e3}},    {"s", {"us", 1e6}}};
    cli_unit chosen = {si, 1};
    for (size_t k = 0; k < sizeof units / sizeof *units; k++)
        if (!strcmp(units[k].si, si)) {
            chosen = units[k].of;
            if (fabs(size) * chosen.factor >= 0.1)
                break;
        }
    return chosen;
}

void cli_put_foreign(const char *text)
{
    while (text && *text) {
        int control = control_bytes(text);
        if (!control)
            putchar(*text++);
        for (; control > 0; control--)
            printf("\\x%02x", (unsigned)(unsigned char)*text++);
    }
}

int cli_usage(const cli_call *call, const char *format, ...)
{
    va_list args;
    fprintf(stderr, "overroll %s: ", call->verb->name);
    va_start(args, format);
    vfprintf(stderr, format, args);
    va_end(args);
    fputc('\n', stderr);
    return CLI_USAGE;
}

/* ------------------------------------------------------ access to options */

const char *cli_value_at(const cli_call *call, const char *name, int k)
{
    for (int i = 0; i < call->givens; i++) {
        const cli_option *option = call->given[i].option;
        if (option && !strcmp(option->name, name) && k-- == 0)
            return call->given[i].value;
    }
    return NULL;
}

const char *cli_value(const cli_call *call, const char *name)
{
    return cli_value_at(call, name, 0);
}

bool cli_flag(const cli_call *call, const char *name)
{
    return cli_value(call, name) != NULL;
}

int cli_choice(const char *word, const char *const *words)
{
    for (int k = 0; words[k]; k++)
        if (strcmp(word, words[k]) == 0)
            return k;
    return -1;
}

void cli_join(const char *const *words, size_t n, char *text, size_t capacity)
{
    size_t used = 0;
    text[0] = '\0';
    for (size_t k = 0; k < n && words[k] && used < capacity; k++)
        used += (size_t)snprintf(text + used, capacity - used, "%s%s",
                                 k ? ", " : "", words[k]);
}

size_t cli_count(const cli_call *call, const char *name, size_t maximum,
                 size_t otherwise)
{
    const char *text = cli_value(call, name);
    if (!text)
        return otherwise;
    char *end;
    long n = strtol(text, &end, 10);
    if (!*end && end != text && n >= 1 && (size_t)n <= maximum)
        return (size_t)n;
    cli_usage(call, "%s%s %s: must be a whole number from 1 to %zu",
              name[1] ? "--" : "-", name, text, maximum);
    return 0;
}

/* ---------------------------------------------------------------- parsing */

static const cli_option *find(const cli_option *options, const char *name,
                              size_t length)
{
    for (; options && options->name; options++)
        if (strlen(options->name) == length &&
            !strncmp(options->name, name, length))
            return options;
    return NULL;
}

/* Synonyms of options: --output is -o, -h is --help. */
static const char *const aliases[][2] = {
    {"h", "help"}, {"output", "o"}, {"quiet", "q"}, {"verbose", "v"}};

static const cli_option *find_option(const cli_verb *verb, const char *name,
                                     size_t length)
{
    const cli_option *option = find(verb->options, name, length);
    if (!option)
        option = find(common, name, length);
    for (size_t k = 0; !option && k < sizeof aliases / sizeof *aliases; k++)
        if (strlen(aliases[k][0]) == length &&
            !strncmp(aliases[k][0], name, length))
            return find_option(verb, aliases[k][1], strlen(aliases[k][1]));
    return option;
}

static int unknown_option(const cli_call *call, const char *given,
                          const char *name)
{
    const char *names[64], *meant;
    size_t n = 0;
    const cli_option *o;
    for (o = call->verb->options; o && o->name && n < 60; o++)
        names[n++] = o->name;
    for (o = common; o->name; o++)
        names[n++] = o->name;
    for (size_t k = 0; k < n; k++)
        if (!strcasecmp(name, names[k]))
            return cli_usage(call, "unknown option '%s'; did you mean '--%s'?",
                             given, names[k]);
    meant = ovr_suggest(name, names, n);
    if (meant && strlen(meant) > 1)
        return cli_usage(call, "unknown option '%s'; did you mean '--%s'?",
                         given, meant);
    return cli_usage(call, "unknown option '%s'; see 'overroll help %s'", given,
                     call->verb->name);
}

/* True for an option; negative numbers are none. */
static bool is_option(const char *text)
{
    return text[0] == '-' && text[1] != '\0' && !strchr("0123456789.", text[1]);
}

/* Handles argv[*i]; increments *i if the value is the next argument. */
static int parse_option(cli_call *call, int argc, char **argv, int *i)
{
    const char *given = argv[*i];
    const char *name = given + (given[1] == '-' ? 2 : 1);
    const char *equals = strchr(name, '=');
    size_t length = equals ? (size_t)(equals - name) : strlen(name);
    const cli_option *option = find_option(call->verb, name, length);
    cli_given *slot = &call->given[call->givens];

    if (!option)
        return unknown_option(call, given, name);
    if (!option->repeats && cli_flag(call, option->name))
        return cli_usage(call, "option '%.*s' is given twice",
                         (int)(name - given + (long)length), given);
    slot->option = option;
    slot->value = "";
    if (!option->argument && equals)
        return cli_usage(call, "option '%.*s' has no value",
                         (int)(name - given + (long)length), given);
    if (option->argument && equals) {
        slot->value = equals + 1;
    } else if (option->argument && *option->argument == '[') {
        if (*i + 1 < argc && !is_option(argv[*i + 1]) &&
            access(argv[*i + 1], F_OK) != 0)
            slot->value = argv[++*i];
    } else if (option->argument) {
        if (*i + 1 >= argc)
            return cli_usage(call, "option '%s' needs a value: %s", given,
                             option->argument);
        slot->value = argv[++*i];
    }
    call->givens++;
    return CLI_DONE;
}

static bool same_file(const char *one, const char *other)
{
    struct stat a, b;
    return stat(one, &a) == 0 && stat(other, &b) == 0 && a.st_ino == b.st_ino &&
           a.st_dev == b.st_dev;
}

static bool is_folder(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 && S_ISDIR(about.st_mode);
}

/* Returns the suffix of a known kind of file other than those in `own`, or
 * NULL. */
static const char *other_ending(const char *path, const char *own)
{
    static const char *const known[] = {
        ".csv",  ".tsv", ".txt", ".dat",  ".m",   ".json", ".ini",
        ".gp",   ".h5",  ".nc",  ".hdf5", ".png", ".svg",  ".pdf",
        ".html", ".mp4", ".gif", ".webm", ".xls", ".xlsx", ".x3p"};
    const char *dot = strrchr(path, '.');
    for (size_t k = 0; dot && k < sizeof known / sizeof *known; k++)
        if (strcmp(dot, known[k]) == 0 && !strstr(own, known[k]))
            return known[k];
    return NULL;
}

/* Rejects an output name with the suffix of another kind of file. Results,
 * pictures, pages and movies are checked where they are written. */
static int check_ending(const cli_call *call)
{
    static const struct {
        const char *verb, *option, *kind, *own;
    } outputs[] = {
        {"export", "o", "is a table", ".csv, .tsv, .txt, .dat or .m"},
        {"find", "table", "is a table", ".csv"},
        {"find", "results", "is a folder", ""},
        {"frames", "o", "is a folder", ""},
        {"init", "o", "is a case", ".ini or .txt"},
        {"plot", "script", "is a gnuplot script", ".gp or .txt"},
        {"sweep", "o", "is a folder", ""},
    };
    for (size_t k = 0; k < sizeof outputs / sizeof *outputs; k++) {
        const char *path = strcmp(call->verb->name, outputs[k].verb)
                               ? NULL
                               : cli_value(call, outputs[k].option);
        const char *ending = path ? other_ending(path, outputs[k].own) : NULL;
        if (ending && (*outputs[k].own || !is_folder(path)))
            return cli_usage(call, "%s: the output %s, not a %s file%s%s", path,
                             outputs[k].kind, ending,
                             *outputs[k].own ? "; use NAME" : "",
                             outputs[k].own);
    }
    return CLI_DONE;
}

int cli_check_outputs(const cli_call *call)
{
    static const char *const outputs[] = {
        "o", "script", "movie", "collect", "convert", "plot", "table"};
    for (size_t k = 0; k < sizeof outputs / sizeof *outputs; k++) {
        const char *path = cli_value(call, outputs[k]);
        for (int i = 0; path && i < call->arguments; i++)
            if (same_file(path, call->argument[i]))
                return cli_usage(call,
                                 "%s: is an input file and cannot also "
                                 "be the output",
                                 path);
    }
    return check_ending(call);
}

static int check_count(const cli_call *call)
{
    const cli_verb *verb = call->verb;
    if (cli_flag(call, "help"))
        return CLI_DONE;
    if (call->arguments < verb->minimum)
        return cli_usage(call, "%s is missing; usage: overroll %s %s",
                         call->arguments ? "an argument" : "the input file",
                         verb->name, verb->arguments);
    if (call->arguments > verb->maximum)
        return cli_usage(call, "unexpected '%s'; usage: overroll %s %s",
                         call->argument[verb->maximum], verb->name,
                         verb->arguments);
    return CLI_DONE;
}

int cli_parse(cli_call *call, const cli_verb *verb, int argc, char **argv)
{
    bool options = true;
    size_t capacity = (size_t)argc + 1;
    memset(call, 0, sizeof *call);
    call->verb = verb;
    call->argument = calloc(capacity, sizeof *call->argument);
    call->given = calloc(capacity, sizeof *call->given);
    if (!call->argument || !call->given) {
        fputs("overroll: out of memory\n", stderr);
        return CLI_FAILED;
    }
    for (int i = 0; i < argc; i++) {
        int code = CLI_DONE;
        if (options && !strcmp(argv[i], "--"))
            options = false;
        else if (options && is_option(argv[i]))
            code = parse_option(call, argc, argv, &i);
        else
            call->argument[call->arguments++] = argv[i];
        if (code)
            return code;
    }
    call->verbosity = cli_flag(call, "v") - cli_flag(call, "q");
    call->json = cli_flag(call, "json");
    if (call->json && verb->no_json && !cli_flag(call, "help")) {
        fprintf(stderr,
                "overroll %s: --json is not an option of commands that "
                "write tables, pictures or text\n",
                verb->name);
        return CLI_USAGE;
    }
    return check_count(call);
}

void cli_free(cli_call *call)
{
    free(call->argument);
    free(call->given);
}

/* ------------------------------------------------------------------- help */

const cli_verb *cli_find_verb(const cli_verb *const *verbs, const char *name)
{
    while (*verbs && strcmp((*verbs)->name, name) != 0)
        verbs++;
    return *verbs;
}

static void print_options(const cli_verb *verb, const cli_option *option,
                          FILE *to)
{
    for (; option && option->name; option++) {
        char left[64];
        if (verb->no_json && !strcmp(option->name, "json"))
            continue;
        bool letter = option->name[1] == '\0' && option->name[0] >= 'a';
        snprintf(left, sizeof left, "%s%s%s%s", letter ? "-" : "--",
                 option->name, option->argument ? " " : "",
                 option->argument ? option->argument : "");
        fprintf(to, "  %-22s %s\n", left, option->help);
    }
}

void cli_print_help(const cli_verb *verb, FILE *to)
{
    fprintf(to, "usage: overroll %s %s\n\n%s\n", verb->name, verb->arguments,
            verb->summary);
    if (verb->help)
        fprintf(to, "\n%s\n", verb->help);
    fputs("\nOptions:\n", to);
    print_options(verb, verb->options, to);
    print_options(verb, common, to);
}
