/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/sweep_task.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

#include "cli/run.h"

enum { PATH_ROOM = 4400 };

const char *sweep_state_name(sweep_state state)
{
    static const char *const names[] = {"waiting",  "stopped", "running",
                                        "finished", "failed",  "changed"};
    return names[state];
}

bool sweep_wanted(const sweep_how *how, sweep_state state)
{
    if (state == SWEEP_RUNNING)
        return false;
    if (how->redo || state == SWEEP_WAITING || state == SWEEP_STOPPED)
        return true;
    return how->retry && state == SWEEP_FAILED;
}

/* ------------------------------------------------------------------ files */

static bool exists(const study *s, size_t task, const char *ending)
{
    char path[PATH_ROOM];
    study_file(s, task, ending, path, sizeof path);
    return access(path, F_OK) == 0;
}

static void discard(const study *s, size_t task, const char *ending)
{
    char path[PATH_ROOM];
    study_file(s, task, ending, path, sizeof path);
    unlink(path);
}

/* The names are ours, not the user's: no link that somebody has put there is
 * followed. */
static int open_file(const study *s, size_t task, const char *ending, int how)
{
    char path[PATH_ROOM];
    study_file(s, task, ending, path, sizeof path);
    return open(path, how | O_NOFOLLOW, 0666);
}

/* Standard output or error to a file of the task. */
static bool redirect(const study *s, size_t task, const char *ending, int to,
                     int how)
{
    int fd = open_file(s, task, ending, how | O_CREAT | O_WRONLY);
    bool done = fd >= 0 && dup2(fd, to) >= 0;
    if (fd >= 0)
        close(fd);
    return done;
}

/* ------------------------------------------------------------------ state */

/* Whether what was run is what the study now asks for. */
static bool same_case(const study *s, size_t task, int fd)
{
    ovr_error err = {0};
    ovr_case *c = study_case(s, task, &err);
    const char *text = c ? ovr_case_text(c, &err) : NULL;
    size_t length = text ? strlen(text) : 0;
    char *found = text ? malloc(length + 2) : NULL;
    bool same = false;
    if (found) {
        ssize_t n = pread(fd, found, length + 1, 0);
        same = n >= 0 && (size_t)n == length && !memcmp(found, text, length);
    }
    free(found);
    ovr_case_free(c);
    return same;
}

/* By the files alone, the case being ours. */
static sweep_state state_by_files(const study *s, size_t task)
{
    if (exists(s, task, ".json"))
        return SWEEP_FINISHED;
    if (exists(s, task, ".failed"))
        return SWEEP_FAILED;
    return exists(s, task, ".h5") ? SWEEP_STOPPED : SWEEP_WAITING;
}

sweep_state sweep_state_of(const study *s, size_t task)
{
    sweep_state state = state_by_files(s, task);
    int fd = open_file(s, task, ".ini", O_RDWR);
    if (fd < 0) /* none: what lies there is not ours */
        return state == SWEEP_WAITING ? SWEEP_WAITING : SWEEP_CHANGED;
    if (flock(fd, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        state = SWEEP_RUNNING;
    else if (state != SWEEP_WAITING && !same_case(s, task, fd))
        state = SWEEP_CHANGED;
    close(fd);
    return state;
}

void sweep_message(const study *s, size_t task, char *text, size_t room)
{
    char path[PATH_ROOM];
    FILE *from;
    text[0] = '\0';
    study_file(s, task, ".failed", path, sizeof path);
    from = fopen(path, "r");
    if (!from)
        return;
    if (!fgets(text, (int)room, from))
        text[0] = '\0';
    text[strcspn(text, "\n")] = '\0';
    fclose(from);
}

/* --------------------------------------------------------------- endings */

/* The last line that the task said, which tells why it failed. */
static void last_words(const study *s, size_t task, char *text, size_t room)
{
    char path[PATH_ROOM], line[1100];
    FILE *from;
    study_file(s, task, ".log", path, sizeof path);
    from = fopen(path, "r");
    snprintf(text, room, "no message");
    while (from && fgets(line, sizeof line, from))
        snprintf(text, room, "%.*s", (int)strcspn(line, "\n"), line);
    if (from)
        fclose(from);
}

static void mark_failed(const study *s, size_t task, const char *message,
                        int code)
{
    char path[PATH_ROOM];
    FILE *to;
    study_file(s, task, ".failed", path, sizeof path);
    unlink(path);
    to = fopen(path, "wx");
    if (!to)
        return;
    fprintf(to, "%s\nexit code %d\n", message, code);
    fclose(to);
}

/* One that was killed may be gone on with; one that crashed may not. */
void sweep_died(const study *s, size_t task, int number)
{
    char message[80];
    if (number == SIGKILL || number == SIGTERM || number == SIGINT ||
        number == SIGHUP)
        return;
    snprintf(message, sizeof message, "killed by signal %d", number);
    mark_failed(s, task, message, 128 + number);
}

/* The summary gets its name when it is whole. */
static int keep_summary(const study *s, size_t task, int code)
{
    char part[PATH_ROOM], path[PATH_ROOM];
    bool whole = fflush(stdout) == 0 && !ferror(stdout) &&
                 fsync(STDOUT_FILENO) == 0;
    study_file(s, task, ".json.part", part, sizeof part);
    study_file(s, task, ".json", path, sizeof path);
    if (whole && rename(part, path) == 0)
        return code;
    fprintf(stderr, "%s: cannot be written: %s\n", path, strerror(errno));
    return CLI_FAILED;
}

static int end_task(const study *s, size_t task, int code)
{
    char message[1100];
    if (code == CLI_DONE || code == CLI_EARLY)
        code = keep_summary(s, task, code);
    if (code == CLI_DONE || code == CLI_EARLY)
        return code;
    discard(s, task, ".json.part");
    if (code > CLI_SIGNAL)
        return code;
    fflush(stderr);
    last_words(s, task, message, sizeof message);
    mark_failed(s, task, message, code);
    return code;
}

/* ------------------------------------------------------------------- work */

/* The case into the locked file, for those who come later. */
static bool write_case(int fd, ovr_case *c)
{
    const char *text = ovr_case_text(c, NULL);
    size_t length = text ? strlen(text) : 0;
    return text && ftruncate(fd, 0) == 0 &&
           pwrite(fd, text, length, 0) == (ssize_t)length && fsync(fd) == 0;
}

static void start_afresh(const study *s, size_t task)
{
    static const char *const endings[] = {".json", ".json.part",  ".failed",
                                          ".h5",   ".h5.restart", ".log"};
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++)
        discard(s, task, endings[i]);
}

static int run_case(const study *s, size_t task, const cli_call *call,
                    sweep_state state, int fd)
{
    char path[PATH_ROOM];
    ovr_error err = {0};
    ovr_case *c = study_case(s, task, &err);
    int code;
    study_file(s, task, ".h5", path, sizeof path);
    if (!c)
        return cli_fail(&err);
    if (!write_case(fd, c)) {
        ovr_case_free(c);
        ovr_fail(&err, OVR_IO, "%s: its case cannot be written: %s", path,
                 strerror(errno));
        return cli_fail(&err);
    }
    if (state == SWEEP_STOPPED && s->results)
        code = cli_resume_file(call, path);
    else
        code = cli_run_case(call, c, s->results ? path : NULL, false);
    ovr_case_free(c);
    return code;
}

static int work_locked(const study *s, size_t task, const sweep_how *how,
                       volatile double *done, int fd)
{
    cli_call call = *how->call;
    sweep_state state = state_by_files(s, task);
    if (state != SWEEP_WAITING && !same_case(s, task, fd))
        state = SWEEP_CHANGED;
    if (!sweep_wanted(how, state)) /* another was faster */
        return CLI_DONE;
    if (state != SWEEP_STOPPED || how->redo) {
        start_afresh(s, task);
        state = SWEEP_WAITING;
    }
    if (!redirect(s, task, ".json.part", STDOUT_FILENO, O_TRUNC) ||
        !redirect(s, task, ".log", STDERR_FILENO, O_APPEND))
        return CLI_FAILED;
    call.json = true;
    call.verbosity = 0;
    call.done = done;
    return end_task(s, task, run_case(s, task, &call, state, fd));
}

/* Somebody who only looks at the state may have the lock for a moment. */
static bool lock(int fd)
{
    const struct timespec moment = {0, 20000000};
    for (int attempt = 0; attempt < 5; attempt++) {
        if (flock(fd, LOCK_EX | LOCK_NB) == 0)
            return true;
        nanosleep(&moment, NULL);
    }
    return false;
}

int sweep_work(const study *s, size_t task, const sweep_how *how,
               volatile double *done)
{
    int fd = open_file(s, task, ".ini", O_RDWR | O_CREAT);
    int code = CLI_DONE;
    if (fd < 0) {
        fprintf(stderr, "%s/%s.ini: cannot be written: %s\n", s->output,
                s->name[task], strerror(errno));
        return CLI_FAILED;
    }
    if (lock(fd))
        code = work_locked(s, task, how, done, fd);
    close(fd);
    return code;
}
