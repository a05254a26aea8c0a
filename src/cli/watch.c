/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Prints the progress, messages and end of a run. */
#include "cli/watch.h"

#include <hdf5.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "cli/report.h"
#include "cli/signals.h"

/* ----------------------------------------------------------------- Progress */

static const double INTERVAL = 0.1; /* s between two updates */

double cli_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* True if stderr is a terminal, or a file (a job's log), which has a line every
 * 10 %. A pipe shows no progress. */
static bool is_file_or_terminal(void)
{
    struct stat standard_error;
    return isatty(STDERR_FILENO) ||
           (fstat(STDERR_FILENO, &standard_error) == 0 &&
            S_ISREG(standard_error.st_mode));
}

cli_progress cli_progress_begin(int verbosity, double fraction)
{
    const char *kind = getenv("TERM");
    cli_progress progress = {0};
    progress.shown = verbosity > 0 || (verbosity == 0 && is_file_or_terminal());
    progress.terminal = isatty(STDERR_FILENO) &&
                        (!kind || strcmp(kind, "dumb") != 0);
    progress.begun = cli_seconds();
    progress.from = fraction;
    progress.tenths = (int)(10 * fraction);
    return progress;
}

static void print_time(double seconds)
{
    if (seconds < 3600)
        fprintf(stderr, "%.0f:%02.0f", floor(seconds / 60),
                floor(fmod(seconds, 60)));
    else
        fprintf(stderr, "%.0f:%02.0f h", floor(seconds / 3600),
                floor(fmod(seconds, 3600) / 60));
}

static void print_line(const cli_progress *progress, double fraction,
                       const char *what)
{
    double spent = cli_seconds() - progress->begun;
    double done = fraction - progress->from;
    fprintf(stderr, "%3.0f %%  %s", floor(100 * fraction), what);
    if (done > 1e-3 && fraction < 1) {
        fputs("  left ", stderr);
        print_time(spent * (1 - fraction) / done);
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
        print_line(progress, fraction, what);
        fputc('\n', stderr);
        return;
    }
    now = cli_seconds();
    if (progress->line && now - progress->last < INTERVAL && fraction < 1)
        return;
    progress->last = now;
    progress->line = true;
    fputc('\r', stderr);
    print_line(progress, fraction, what);
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
        sigaction(SIGHUP, &action, NULL); /* nohup: still ignored */
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

void cli_silence_the_end(void)
{
    H5dont_atexit();
}

static void print_message(void *data, ovr_message_kind kind, const char *text)
{
    static const char *const before[] = {
        "overroll: warning: ", "overroll: ", ""};
    cli_watch *watch = data;
    if (watch->call->verbosity < 0)
        return;
    cli_progress_end(&watch->progress);
    fprintf(stderr, "%s%s\n", before[kind], text);
}

static void progress(void *data, const ovr_run *run, double fraction)
{
    cli_watch *watch = data;
    const ovr_simulation *sim = ovr_run_get_info(run)->sim;
    const ovr_state *state = ovr_simulation_state(sim);
    char what[120];
    if (watch->progress.begun == 0) /* in a sweep, to the case's log */
        watch->progress = cli_progress_begin(watch->call->verbosity, fraction);
    const ovr_run_info *info = ovr_run_get_info(run);
    int used = info->passes ? snprintf(what, sizeof what, "pass %d of %d  ",
                                       info->pass, info->passes)
                            : 0;
    snprintf(what + used, sizeof what - (size_t)used,
             "T = %.3f of %g  step %ld  residual %.1e", state->T,
             info->setup->march->end, state->step,
             ovr_simulation_observation(sim)->residual);
    cli_progress_show(&watch->progress, fraction, what);
}

ovr_run_options cli_run_options(cli_watch *watch)
{
    ovr_run_options how = {0};
    how.data = watch;
    how.say = print_message;
    how.stop = how.interrupt = cli_stop;
    how.progress = progress;
    how.estimate_error = cli_flag(watch->call, "estimate-error");
    return how;
}

/* False before the steady start is solved: there is no film. */
static bool has_begun(const ovr_run *run)
{
    const ovr_simulation *sim = ovr_run_get_info(run)->sim;
    return sim && ovr_simulation_observation(sim)->H_min != 0;
}

bool cli_has_result(const ovr_run *run, ovr_status status)
{
    return !status || (status == OVR_STOPPED && has_begun(run)) ||
           status == OVR_NOT_CONVERGED || status == OVR_IMPOSSIBLE;
}

/* Prints where a signal stopped the run, and how to continue it. */
static void report_signal(const ovr_run *run)
{
    const ovr_run_info *info = ovr_run_get_info(run);
    const char *file = info->passes ? info->passes_file : info->output;
    fprintf(stderr, "overroll: stopped by signal %d ", cli_signal());
    if (has_begun(run))
        fprintf(stderr, "at T = %g", ovr_simulation_state(info->sim)->T);
    else
        fprintf(stderr, "in the steady start");
    if (file && info->transient && access(file, F_OK) == 0)
        fprintf(stderr, "; 'overroll resume %s' continues the run", file);
    fputc('\n', stderr);
}

int cli_run_code(const cli_call *call, const ovr_run *run, ovr_status status,
                 const ovr_error *err)
{
    const ovr_run_info *info = ovr_run_get_info(run);
    if (status == OVR_STOPPED && cli_signal()) {
        if (call->verbosity >= 0)
            report_signal(run);
        return CLI_SIGNAL + cli_signal();
    }
    if (status)
        return cli_fail(err);
    if (info->marked && call->verbosity >= 0)
        fprintf(stderr,
                "overroll: %ld of %ld steps were accepted above the "
                "tolerance or have inconsistent temperatures; they are "
                "flagged in the history\n",
                info->marked, ovr_simulation_statistics(info->sim)->steps);
    if (info->marked)
        return CLI_EARLY;
    if (info->converged)
        return CLI_DONE;
    return call->verb->steady ? CLI_FAILED : CLI_EARLY;
}

int cli_finish_run(cli_watch *watch, ovr_run *run, ovr_error *err)
{
    const cli_call *call = watch->call;
    ovr_status status;
    int code;
    if (!run)
        return err->status || call->verbosity >= 0 ? cli_fail(err) : CLI_DONE;
    if (!call->verb->steady)
        cli_catch_signals();
    watch->progress = cli_progress_begin(call->verbosity,
                                         ovr_run_get_info(run)->fraction);
    status = ovr_run_execute(run, err);
    cli_progress_end(&watch->progress);
    if (cli_has_result(run, status))
        cli_report(call, ovr_run_get_info(run));
    code = cli_run_code(call, run, status, err);
    ovr_run_free(run);
    return code;
}
