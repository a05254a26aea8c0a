/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program: calls the command (to add one, see cli.h). */
#include <fcntl.h>
#include <stdio.h>
#include <string.h>

#include <expat.h>
#include <fftw3.h>
#include <gsl/gsl_version.h>
#include <hdf5.h>
#include <zlib.h>

#include "cli/cli.h"

/* one row each */
/* clang-format off */
static const cli_verb *const verbs[] = {
    &cli_steady,
    &cli_run,
    &cli_resume,
    &cli_check,
    &cli_info,
    &cli_find,
    &cli_sweep,
    &cli_stress,
    &cli_export,
    &cli_plot,
    &cli_frames,
    &cli_view,
    &cli_profile,
    &cli_init,
    &cli_help,
    NULL,
};
/* clang-format on */

static void print_version(void)
{
    unsigned major = 0, minor = 0, release = 0;
    H5get_libversion(&major, &minor, &release);
    printf("overroll %s\n", OVERROLL_VERSION);
    printf("GSL %s, HDF5 %u.%u.%u, zlib %s, %s, %s\n", gsl_version, major,
           minor, release, zlibVersion(), XML_ExpatVersion(), fftw_version);
}

/* Prints the short help, ten lines. */
static void print_short_help(void)
{
    puts(
        "overroll simulates transient elastohydrodynamically lubricated line\n"
        "contacts with rough surfaces.\n"
        "\n"
        "  overroll steady --M 20 --L 10 --level 9   solve one contact\n"
        "  overroll run dent.ini -o dent.h5          roll a dent through it\n");
    fputs("Commands:", stdout);
    for (const cli_verb *const *verb = verbs; *verb; verb++)
        printf(" %s", (*verb)->name);
    puts("\n"
         "overroll help          lists the commands\n"
         "overroll help TOPIC    explains a command or a section of the "
         "case\n"
         "overroll --version     prints the versions of program and libraries");
}

static int no_such_verb(const char *name)
{
    const char *names[64];
    const char *meant;
    size_t n = 0;
    for (const cli_verb *const *verb = verbs; *verb && n < 64; verb++)
        names[n++] = (*verb)->name;
    meant = ovr_suggest(name, names, n);
    if (meant)
        fprintf(stderr, "overroll: no command '%s'; did you mean '%s'?\n", name,
                meant);
    else
        fprintf(stderr,
                "overroll: no command '%s'; 'overroll help' lists them\n",
                name);
    return CLI_USAGE;
}

static int run_verb(const cli_verb *verb, int argc, char **argv)
{
    cli_call call;
    int code = cli_parse(&call, verb, argc, argv);
    call.verbs = verbs;
    if (code == CLI_DONE && cli_flag(&call, "help"))
        cli_print_help(verb, stdout);
    else if (code == CLI_DONE && (code = cli_check_outputs(&call)) == CLI_DONE)
        code = verb->run(&call);
    cli_free(&call);
    return code;
}

/* Reports a failure to write stdout (a full disk). */
static int close_stdout(int code)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return code;
    fputs("overroll: cannot write to standard output\n", stderr);
    return code == CLI_DONE ? CLI_FAILED : code;
}

/* Opens missing standard streams. Otherwise an output file could have the
 * number of a closed stream, and printed text would be written to it. */
static bool open_missing(void)
{
    for (int fd = 0; fd <= 2; fd++)
        if (fcntl(fd, F_GETFD) < 0 && open("/dev/null", O_RDWR) != fd)
            return false;
    return true;
}

int main(int argc, char **argv)
{
    const cli_verb *verb;
    if (!open_missing())
        return CLI_FAILED;
    if (argc < 2) {
        print_short_help();
        return close_stdout(CLI_DONE);
    }
    if (!strcmp(argv[1], "--version")) {
        print_version();
        return close_stdout(CLI_DONE);
    }
    if (!strcmp(argv[1], "--help") || !strcmp(argv[1], "-h"))
        verb = &cli_help;
    else
        verb = cli_find_verb(verbs, argv[1]);
    if (!verb)
        return no_such_verb(argv[1]);
    return close_stdout(run_verb(verb, argc - 2, argv + 2));
}
