/* SPDX-License-Identifier: GPL-3.0-or-later */

#include "cli/progress.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "cli/signals.h"

/* ----------------------------------------------------------------- Progress */

static const double INTERVAL = 0.1; /* s between two rewritings */

double cli_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

cli_progress cli_progress_begin(int verbosity, double fraction)
{
    const char *kind = getenv("TERM");
    cli_progress progress = {0};
    progress.shown = verbosity >= 0;
    progress.terminal = isatty(STDERR_FILENO) &&
                        (!kind || strcmp(kind, "dumb") != 0);
    progress.begun = cli_seconds();
    progress.from = fraction;
    progress.tenths = (int)(10 * fraction);
    return progress;
}

static void put_time(double seconds)
{
    if (seconds < 3600)
        fprintf(stderr, "%.0f:%02.0f", floor(seconds / 60),
                floor(fmod(seconds, 60)));
    else
        fprintf(stderr, "%.0f:%02.0f h", floor(seconds / 3600),
                floor(fmod(seconds, 3600) / 60));
}

static void put_line(const cli_progress *progress, double fraction,
                     const char *what)
{
    double spent = cli_seconds() - progress->begun;
    double done = fraction - progress->from;
    fprintf(stderr, "%3.0f %%  %s", floor(100 * fraction), what);
    if (done > 1e-3 && fraction < 1) {
        fputs("  left ", stderr);
        put_time(spent * (1 - fraction) / done);
    }
}

void cli_progress_show(cli_progress *progress, double fraction,
                       const char *what)
{
    double now;
    if (!progress->shown)
        return;
    fraction = fmax(0, fmin(fraction, 1));
    if (!progress->terminal) {
        if ((int)(10 * fraction + 1e-9) <= progress->tenths)
            return;
        progress->tenths = (int)(10 * fraction + 1e-9);
        put_line(progress, fraction, what);
        fputc('\n', stderr);
        return;
    }
    now = cli_seconds();
    if (progress->line && now - progress->last < INTERVAL && fraction < 1)
        return;
    progress->last = now;
    progress->line = true;
    fputc('\r', stderr);
    put_line(progress, fraction, what);
    fputs("\033[K", stderr);
    fflush(stderr);
}

void cli_progress_end(cli_progress *progress)
{
    if (progress->line)
        fputs("\r\033[K", stderr);
    progress->line = false;
}

/* ------------------------------------------------------------------ Signals */

static volatile sig_atomic_t asked;

static void remember(int number)
{
    asked = number;
}

void cli_catch_signals(void)
{
    struct sigaction action, before;
    memset(&action, 0, sizeof action);
    action.sa_handler = remember;
    sigemptyset(&action.sa_mask);
    action.sa_flags = (int)SA_RESETHAND | SA_RESTART;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    if (sigaction(SIGHUP, NULL, &before) == 0 && before.sa_handler != SIG_IGN)
        sigaction(SIGHUP, &action, NULL); /* nohup: it stays ignored */
}

int cli_signal(void)
{
    return asked;
}

bool cli_stop(void *nothing)
{
    (void)nothing;
    return asked != 0;
}
