/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Shared by the commands.
 *
 * To add a subcommand: write src/cli/NAME.c that defines
 *     const cli_verb cli_NAME = {.name = "NAME", ..., .run = run};
 * declare it in the list below and add one row to the table in main.c. Its
 * `run` receives the parsed command line and returns the exit code. The common
 * options (-q, -v, --json, --help) are parsed for every command; its own ones
 * are in its table of options.
 *
 * stdout carries results, stderr messages. A message is one line with the error
 * and the allowed values.
 */
#ifndef OVR_CLI_CLI_H
#define OVR_CLI_CLI_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "overroll/overroll.h"

enum {
    CLI_DONE = 0,
    CLI_FAILED = 1, /* did not converge; a write failed */
    CLI_USAGE = 2,  /* invalid usage or input; output cannot be created */
    CLI_EARLY = 3,  /* stopped early or with flagged steps; output is valid */
    CLI_SIGNAL = 128
};

/* An option. "force" is --force; a name of one lower-case letter (or "M", "L"
 * with two dashes) is -o. With an argument: --name VALUE, --name=VALUE or -o
 * VALUE. */
typedef struct cli_option {
    const char *name;
    const char *argument; /* name of the argument in the help text, in brackets
                           * if optional (not for files); NULL: a flag */
    const char *help;
    bool repeats; /* may be given more than once */
} cli_option;

typedef struct cli_call cli_call;

typedef struct cli_verb {
    const char *name;
    const char *arguments; /* "CASE [-o OUT.h5]" */
    const char *summary;   /* description of one line */
    const char *help;      /* paragraphs for `overroll help NAME`, or NULL */
    const cli_option *options; /* ends with name NULL; may be NULL */
    int minimum, maximum;      /* allowed number of positional arguments */
    int (*run)(cli_call *call);
    bool steady;  /* no time steps: signals end it, and a solution that has not
                   * converged has failed */
    bool no_json; /* the output is a table, picture or text: no --json */
} cli_verb;

extern const cli_verb cli_steady, cli_run, cli_resume, cli_check, cli_init;
extern const cli_verb cli_info, cli_export, cli_profile, cli_help, cli_plot;
extern const cli_verb cli_frames, cli_view, cli_sweep, cli_stress, cli_find;

typedef struct cli_given {
    const cli_option *option;
    const char *value;
} cli_given;

/* A parsed command line. */
struct cli_call {
    const cli_verb *const *verbs; /* all commands; ends with NULL */
    const cli_verb *verb;
    int verbosity; /* -1 quiet, 0, 1 verbose */
    bool json;
    int arguments;
    const char **argument; /* positional arguments */
    int givens;
    cli_given *given;      /* options in the given order */
    volatile double *done; /* progress of a run, written by the march; or
                            * NULL */
};

/* Return whether a flag was given, the value of an option or NULL, and the k-th
 * value of a repeated option or NULL past the last. */
bool cli_flag(const cli_call *call, const char *name);
const char *cli_value(const cli_call *call, const char *name);
const char *cli_value_at(const cli_call *call, const char *name, int k);

/* Returns the index of a word in a list that ends with NULL; -1 if it is not in
 * the list. */
int cli_choice(const char *word, const char *const *words);

/* Joins the first n words of a list, or all up to a NULL, as "a, b, c". */
void cli_join(const char *const *words, size_t n, char *text, size_t capacity);

/* Returns the value of an option, an integer from 1 to `maximum`, or
 * `otherwise` if it is not given. Prints an error and returns 0 for an invalid
 * value. */
size_t cli_count(const cli_call *call, const char *name, size_t maximum,
                 size_t otherwise);

/* Prints the message as one line on stderr and returns the exit code of its
 * status. */
int cli_fail(const ovr_error *err);

/* A listener (`data`: the call): notes and warnings on stderr, unless -q. */
void cli_say(void *data, ovr_message_kind kind, const char *text);

/* Prints external text, or a file name, on stdout. Control characters are
 * escaped: \x1b. */
void cli_put_foreign(const char *text);

/* Unit in which values are printed: "um" and 1e6 for metres. */
typedef struct cli_unit {
    const char *name;
    double factor;
} cli_unit;

/* Returns the largest unit of which `size`, in the unit `si`, is at least a
 * tenth: mm, um or nm for small lengths, GPa or MPa for pressures. Units other
 * than m, Pa and s are kept. */
cli_unit cli_choose_unit(const char *si, double size);

/* Prints "overroll VERB: message" and returns exit code 2. */
int cli_usage(const cli_call *call, const char *format, ...) OVR_PRINTF(2, 3);

/* Prints an error and returns CLI_USAGE if an output file is an input file;
 * links are followed. */
int cli_check_outputs(const cli_call *call);

/* Parses the arguments after the command; returns CLI_DONE, or the exit code
 * after printing an error. `call` must be freed in either case. */
int cli_parse(cli_call *call, const cli_verb *verb, int argc, char **argv);
void cli_free(cli_call *call);

/* Returns the command with this name, or NULL. */
const cli_verb *cli_find_verb(const cli_verb *const *verbs, const char *name);

/* Prints the help of a command: usage, summary, options. */
void cli_print_help(const cli_verb *verb, FILE *to);

/* Help topics that are neither a command nor a key.  The first function returns
 * the name of topic k, or NULL after the last; the second prints a topic and
 * returns false if there is none of that name. */
const char *cli_topic_name(size_t k);
bool cli_help_topic(const char *topic);

/* True if two terms differ at most in capitals, blanks, hyphens and
 * underscores. */
bool cli_same_term(const char *a, const char *b);

/* Returns the topic, section, key or command that explains a usual term of the
 * field ("SRR", "film thickness"), or NULL. */
const char *cli_synonym(const char *term);
void cli_help_units(void);

#endif
