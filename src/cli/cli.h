/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The subcommands share this.
 *
 * To add a subcommand: write src/cli/NAME.c that defines
 *     const cli_verb cli_NAME = {.name = "NAME", ..., .run = run};
 * declare it in the list below and add one row to the table in main.c.
 * Its `run` gets the parsed command line and returns the exit code.  The
 * common options (-q, -v, --json, --help) are parsed for every verb; its own
 * ones are in its table of options.
 *
 * stdout carries results, stderr messages.  A message is one line: what is
 * wrong and what would be right.
 */
#ifndef OVR_CLI_CLI_H
#define OVR_CLI_CLI_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "overroll/overroll.h"

enum {
    CLI_DONE = 0,
    CLI_FAILED = 1, /* did not converge; a write failed on the way */
    CLI_USAGE = 2,  /* bad usage or input, output that cannot be made */
    CLI_EARLY = 3,  /* stopped early or with marked steps; output valid */
    CLI_SIGNAL = 128
};

/* An option: "force" is --force, a name of one lower-case letter (or "M",
 * "L" with both dashes) is -o.  With an argument: --name VALUE, --name=VALUE
 * or -o VALUE. */
typedef struct cli_option {
    const char *name;
    const char *argument; /* what follows, for help; NULL: a flag; in brackets:
                             it may, unless it is a file */
    const char *help;
    bool repeats; /* may be given more than once */
} cli_option;

typedef struct cli_call cli_call;

typedef struct cli_verb {
    const char *name;
    const char *arguments; /* "CASE [-o OUT.h5]" */
    const char *summary;   /* one line */
    const char *help;      /* paragraphs for `overroll help NAME`, or NULL */
    const cli_option *options; /* ends with name NULL; may be NULL */
    int minimum, maximum;      /* positional arguments */
    int (*run)(cli_call *call);
    bool steady; /* does not march: signals end it, and what has not converged
                    has failed */
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
    const cli_verb *const *verbs; /* all; ends with NULL */
    const cli_verb *verb;
    int verbosity; /* -1 quiet, 0, 1 verbose */
    bool json;
    int arguments;
    const char **argument; /* positional */
    int givens;
    cli_given *given;      /* options in the order given */
    volatile double *done; /* a march tells here how far it is, or NULL */
};

/* True if a flag was given; the value of an option or NULL; the k-th value of
 * one that repeats, or NULL behind the last. */
bool cli_flag(const cli_call *call, const char *name);
const char *cli_value(const cli_call *call, const char *name);
const char *cli_value_at(const cli_call *call, const char *name, int k);

/* The place of a word in a list that ends with NULL; -1: it is none of them. */
int cli_choice(const char *word, const char *const *words);

/* Writes the first n words of a list, or all up to a NULL, as "a, b, c". */
void cli_join(const char *const *words, size_t n, char *text, size_t capacity);

/* The whole number from 1 to `maximum` that an option gives, `otherwise` where
 * it is not given; 0 after having said what is needed. */
size_t cli_count(const cli_call *call, const char *name, size_t maximum,
                 size_t otherwise);

/* Prints the message as one line on stderr and returns the exit code that
 * belongs to its status. */
int cli_fail(const ovr_error *err);

/* A listener (`data`: the call): notes and warnings on stderr, unless -q. */
void cli_say(void *data, ovr_message_kind kind, const char *text);

/* Prints a text that comes from a file, or the name of one, on stdout.  Control
 * characters are escaped: \x1b. */
void cli_put_foreign(const char *text);

/* "overroll VERB: message", exit code 2. */
int cli_usage(const cli_call *call, const char *format, ...) OVR_PRINTF(2, 3);

/* CLI_USAGE after having said so when a file that an option would write is one
 * that is read, links followed. */
int cli_check_outputs(const cli_call *call);

/* Parses argv behind the verb; returns CLI_DONE, or the exit code after
 * having printed why. `call` must be freed either way. */
int cli_parse(cli_call *call, const cli_verb *verb, int argc, char **argv);
void cli_free(cli_call *call);

/* NULL: none of the verbs has this name. */
const cli_verb *cli_find_verb(const cli_verb *const *verbs, const char *name);

/* Help of one verb: usage, summary, options. */
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
