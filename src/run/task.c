/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/task.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/lock.h"
#include "overroll/questions.h"
#include "run/internal.h"
#include "run/run.h"

enum { PATH_CAPACITY = 4400 };

const char *ovr_sweep_state_name(ovr_sweep_state state)
{
    static const char *const names[] = {"waiting",  "stopped", "running",
                                        "finished", "failed",  "changed"};
    return names[state];
}

bool ovr_sweep_is_due(const ovr_sweep_options *how, ovr_sweep_state state)
{
    if (!how)
        return false;
    if (state == OVR_SWEEP_RUNNING)
        return false;
    if (how->redo || state == OVR_SWEEP_WAITING || state == OVR_SWEEP_STOPPED)
        return true;
    return how->retry && state == OVR_SWEEP_FAILED;
}

/* ------------------------------------------------------------------ files */

static bool exists(const ovr_study *s, size_t task, const char *ending)
{
    char path[PATH_CAPACITY];
    ovr_study_file(s, task, ending, path, sizeof path);
    return access(path, F_OK) == 0;
}

static void discard(const ovr_study *s, size_t task, const char *ending)
{
    char path[PATH_CAPACITY];
    ovr_study_file(s, task, ending, path, sizeof path);
    unlink(path);
}

/* Opens a file of a task. Links are not followed, because the name is not
 * chosen by the user. */
static int open_file(const ovr_study *s, size_t task, const char *ending,
                     int how)
{
    char path[PATH_CAPACITY];
    ovr_study_file(s, task, ending, path, sizeof path);
    return open(path, how | O_NOFOLLOW, 0666);
}

/* ------------------------------------------------------------------ state */

/* True if the stored case equals the task of the current study. */
static bool same_case(const ovr_study *s, size_t task, int fd)
{
    ovr_error err = {0};
    ovr_case *c = ovr_study_case(s, task, &err);
    ovr_arena arena = ovr_arena_make(&s->arena.allocator);
    const char *text = c ? ovr_study_text(s, c, &arena, &err) : NULL;
    size_t length = text ? strlen(text) : 0;
    char *found = text ? ovr_arena_take(&arena, length + 2, 1, NULL) : NULL;
    bool same = false;
    if (found) {
        ssize_t n = pread(fd, found, length + 1, 0);
        same = n >= 0 && (size_t)n == length && !memcmp(found, text, length);
    }
    ovr_arena_release(&arena);
    ovr_case_free(c);
    return same;
}

/* Returns the state by the files that exist, for a case of this study. */
static ovr_sweep_state state_by_files(const ovr_study *s, size_t task)
{
    if (exists(s, task, ".json") && exists(s, task, ".h5"))
        return OVR_SWEEP_FINISHED;
    if (exists(s, task, ".failed"))
        return OVR_SWEEP_FAILED;
    return exists(s, task, ".h5") || exists(s, task, ".find.csv")
               ? OVR_SWEEP_STOPPED
               : OVR_SWEEP_WAITING;
}

static ovr_rows *open_rows(const ovr_study *s)
{
    return ovr_study_in_rows(s) ? ovr_rows_open(s, false, NULL) : NULL;
}

/* Returns the state of a case without a row whose search has left evaluations
 * of this case or another one. */
static ovr_sweep_state state_of_search(const ovr_study *s, size_t task)
{
    if (!s->find.how.key || !exists(s, task, ".find.csv"))
        return OVR_SWEEP_WAITING;
    int fd = open_file(s, task, ".ini", O_RDONLY);
    bool same = fd >= 0 && same_case(s, task, fd);
    if (fd >= 0)
        close(fd);
    return same ? OVR_SWEEP_STOPPED : OVR_SWEEP_CHANGED;
}

ovr_sweep_state ovr_task_state(const ovr_study *s, const ovr_rows *rows,
                               size_t task)
{
    if (rows && !ovr_rows_elsewhere(rows, task)) {
        ovr_sweep_state in_rows = ovr_rows_state(rows, task);
        return in_rows == OVR_SWEEP_WAITING ? state_of_search(s, task)
                                            : in_rows;
    }
    ovr_sweep_state state = state_by_files(s, task);
    int fd = open_file(s, task, ".ini", O_RDWR);
    if (fd < 0) /* no case file: other files there are foreign */
        return state == OVR_SWEEP_WAITING ? OVR_SWEEP_WAITING
                                          : OVR_SWEEP_CHANGED;
    if (ovr_lock_file(fd, true) == EWOULDBLOCK)
        state = OVR_SWEEP_RUNNING;
    else if (state != OVR_SWEEP_WAITING && !same_case(s, task, fd))
        state = OVR_SWEEP_CHANGED;
    close(fd);
    return state;
}

ovr_sweep_state ovr_sweep_state_of(const ovr_study *s, size_t task)
{
    if (!s || task >= s->tasks)
        return OVR_SWEEP_WAITING;
    ovr_rows *rows = open_rows(s);
    ovr_sweep_state state = ovr_task_state(s, rows, task);
    ovr_rows_close(rows);
    return state;
}

/* True if the case's file is not of this study. A case with results is
 * accepted, because its study may have changed since. */
bool ovr_task_foreign(const ovr_study *s, size_t task)
{
    bool foreign = false;
    if (!s->results && !s->find.how.key)
        return false;
    int fd = state_by_files(s, task) == OVR_SWEEP_WAITING
                 ? open_file(s, task, ".ini", O_RDONLY)
                 : -1;
    if (fd >= 0) {
        foreign = lseek(fd, 0, SEEK_END) > 0 && !same_case(s, task, fd);
        close(fd);
    }
    return foreign;
}

void ovr_sweep_message(const ovr_study *s, size_t task, char *text,
                       size_t capacity)
{
    if (!s || !text)
        return;
    char path[PATH_CAPACITY];
    FILE *from;
    ovr_rows *rows = open_rows(s);
    text[0] = '\0';
    if (rows)
        ovr_rows_message(rows, task, text, capacity);
    ovr_rows_close(rows);
    if (*text)
        return;
    ovr_study_file(s, task, ".failed", path, sizeof path);
    from = fopen(path, "r");
    if (!from)
        return;
    if (!fgets(text, (int)capacity, from))
        text[0] = '\0';
    text[strcspn(text, "\n")] = '\0';
    fclose(from);
}

/* --------------------------------------------------------------- endings */

static void mark_failed(const ovr_study *s, size_t task, const char *message,
                        int code)
{
    char path[PATH_CAPACITY];
    FILE *to;
    ovr_study_file(s, task, ".failed", path, sizeof path);
    unlink(path);
    to = fopen(path, "wx");
    if (!to)
        return;
    fprintf(to, "%s\nexit code %d\n", message, code);
    fclose(to);
}

/* Records a failure after a crash; a killed case may be resumed. */
void ovr_task_died(const ovr_study *s, size_t task, int number)
{
    char message[80];
    if (number == SIGKILL || number == SIGTERM || number == SIGINT ||
        number == SIGHUP)
        return;
    snprintf(message, sizeof message, "killed by signal %d", number);
    ovr_rows *rows = open_rows(s);
    if (rows)
        ovr_rows_fail(rows, task, message, NULL);
    else
        mark_failed(s, task, message, 128 + number);
    ovr_rows_close(rows);
}

/* Renames the summary after it is complete. */
static ovr_status keep_summary(const ovr_study *s, size_t task, FILE *summary,
                               ovr_error *err)
{
    char part[PATH_CAPACITY], path[PATH_CAPACITY];
    bool whole = fflush(summary) == 0 && !ferror(summary) &&
                 fsync(fileno(summary)) == 0;
    ovr_study_file(s, task, ".json.part", part, sizeof part);
    ovr_study_file(s, task, ".json", path, sizeof path);
    if (whole && rename(part, path) == 0)
        return OVR_OK;
    return ovr_fail(err, OVR_IO, "%s: cannot be written: %s", path,
                    strerror(errno));
}

/* ------------------------------------------------------------------- work */

/* A task that is being processed in this process. */
typedef struct working {
    const ovr_study *s;
    size_t task;
    const ovr_sweep_options *how;
    ovr_run_options run; /* options of the caller */
    ovr_shared shared;
    FILE *summary;
    int output, error; /* copies of the process's standard streams, restored
                        * afterwards */
    ovr_rows *rows;    /* tables of the study, or NULL */
    ovr_row *row;      /* numbers of this case, used with `rows` instead of a
                        * summary */
} working;

static void forward_message(void *data, ovr_message_kind kind, const char *text)
{
    const working *w = data;
    if (w->run.say)
        w->run.say(w->run.data, kind, text);
}

static bool stop(void *data)
{
    const working *w = data;
    return *w->shared.stop || (w->run.stop && w->run.stop(w->run.data));
}

static bool interrupt(void *data)
{
    const working *w = data;
    return *w->shared.stop ||
           (w->run.interrupt && w->run.interrupt(w->run.data));
}

static void progress(void *data, const ovr_run *run, double fraction)
{
    const working *w = data;
    *w->shared.done = fraction;
    if (w->run.progress)
        w->run.progress(w->run.data, run, fraction);
}

static ovr_status observe(void *data, const ovr_simulation *sim, ovr_error *err)
{
    const working *w = data;
    return w->run.observe ? w->run.observe(w->run.data, sim, err) : OVR_OK;
}

static ovr_status change(void *data, ovr_case *c, ovr_error *err)
{
    const working *w = data;
    return w->run.change ? w->run.change(w->run.data, c, err) : OVR_OK;
}

/* Writes the case to its locked file, for comparison by later processes. */
static bool write_case(const ovr_study *s, int fd, ovr_case *c)
{
    ovr_arena arena = ovr_arena_make(&s->arena.allocator);
    const char *text = ovr_study_text(s, c, &arena, NULL);
    size_t length = text ? strlen(text) : 0;
    bool written = text && ftruncate(fd, 0) == 0 &&
                   pwrite(fd, text, length, 0) == (ssize_t)length &&
                   fsync(fd) == 0;
    ovr_arena_release(&arena);
    return written;
}

static void start_afresh(const ovr_study *s, size_t task)
{
    static const char *const endings[] = {".json",
                                          ".json.part",
                                          ".failed",
                                          ".h5",
                                          ".h5.journal",
                                          ".h5.restart",
                                          ".log",
                                          ".find.csv",
                                          "-profile-1-before.csv",
                                          "-profile-1-after.csv",
                                          "-profile-2-before.csv",
                                          "-profile-2-after.csv"};
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++)
        discard(s, task, endings[i]);
}

static ovr_run *begin(working *w, ovr_case *c, bool resume, ovr_error *err)
{
    char path[PATH_CAPACITY];
    ovr_run_options how = w->run;
    how.output = w->s->results ? path : NULL;
    how.force = how.from_start = resume; /* the file belongs to the sweep */
    how.steady = false;
    how.no_thread = true; /* the other processors solve other cases */
    how.data = w;
    how.say = forward_message;
    how.stop = stop;
    how.interrupt = interrupt;
    how.progress = progress;
    how.observe = observe;
    how.change = change;
    ovr_study_file(w->s, w->task, ".h5", path, sizeof path);
    return resume ? ovr_run_resume(path, &how, NULL, err)
                  : ovr_run_create(c, &how, NULL, err);
}

/* Writes a line of JSON. */
static void write_line(void *summary, const ovr_summary_line *line)
{
    if (line->form == OVR_SUMMARY_TEXT)
        return;
    if (isfinite(line->number))
        fprintf(summary, "  \"%s\": %.17g,\n", line->key, line->number);
    else
        fprintf(summary, "  \"%s\": null,\n", line->key);
}

static void report(const working *w, const ovr_run *run, const ovr_error *err)
{
    if (w->row && run && err->status == OVR_OK)
        ovr_run_report(ovr_run_get_info(run), ovr_row_add, w->row);
    if (w->how->report) {
        w->how->report(w->how->data, run, err, w->summary);
    } else if (!w->row && run && err->status == OVR_OK) {
        fputs("{\n", w->summary);
        ovr_run_summary(ovr_run_get_info(run), write_line, w->summary);
        fputs("  \"finished\": true\n}\n", w->summary);
    }
}

/* Stores the answer of [find] instead of a run: the answer's column has the
 * key's name. */
static void report_find(const working *w, const ovr_find *find,
                        const ovr_error *err)
{
    if (find && err->status == OVR_OK)
        for (int answer = 0; answer < 2; answer++)
            ovr_find_summary(find, answer, ovr_row_add, w->row);
    if (w->how->report_find)
        w->how->report_find(w->how->data, find, err);
}

static void fail_to_write(const ovr_study *s, size_t task, ovr_error *err)
{
    char path[PATH_CAPACITY];
    int number = errno;
    ovr_study_file(s, task, ".ini", path, sizeof path);
    ovr_fail(err, OVR_IO, "%s: cannot be written: %s", path, strerror(number));
}

/* Performs the search of a case. Evaluations are stored in NAME.find.csv, from
 * which an interrupted search of the case NAME.ini continues. */
static void find_case(working *w, ovr_case *c, ovr_error *err)
{
    ovr_find_options how = w->s->find.how;
    char path[PATH_CAPACITY];
    int fd = open_file(w->s, w->task, ".ini", O_RDWR | O_CREAT);
    bool written = fd >= 0 && write_case(w->s, fd, c);
    if (!written)
        fail_to_write(w->s, w->task, err);
    if (fd >= 0)
        close(fd);
    ovr_study_file(w->s, w->task, ".find.csv", path, sizeof path);
    how.table = path;
    how.go_on = true;
    how.data = w;
    how.say = forward_message;
    how.stop = stop;
    ovr_find *find = written ? ovr_find_create(c, &how, err) : NULL;
    if (find && ovr_find_execute(find, err) == OVR_OK)
        err->status = OVR_OK;
    report_find(w, find, err);
    ovr_find_free(find);
}

/* Runs the case and writes its summary. */
static void run_case(working *w, bool resume, int fd, ovr_error *err)
{
    ovr_case *c = ovr_study_case(w->s, w->task, err);
    ovr_run *run = NULL;
    if (c && !w->rows && !write_case(w->s, fd, c))
        fail_to_write(w->s, w->task, err);
    else if (c && !w->s->find.how.key)
        run = begin(w, c, resume, err);
    if (run && ovr_run_execute(run, err) == OVR_OK)
        err->status = OVR_OK;
    if (c && w->s->find.how.key)
        find_case(w, c, err);
    else
        report(w, run, err);
    if (err->status == OVR_OK && !w->rows)
        keep_summary(w->s, w->task, w->summary, err);
    ovr_run_free(run);
    ovr_case_free(c);
}

/* Saves standard output and error of the process, which may process further
 * tasks. */
static void keep_streams(working *w)
{
    fflush(NULL);
    w->output = dup(STDOUT_FILENO);
    w->error = dup(STDERR_FILENO);
}

static void restore_stream(int kept, int stream)
{
    if (kept < 0)
        return;
    dup2(kept, stream);
    close(kept);
}

static void restore_streams(working *w)
{
    fflush(NULL);
    restore_stream(w->output, STDOUT_FILENO);
    restore_stream(w->error, STDERR_FILENO);
}

/* Redirects standard output and error to the log and opens the summary. */
static bool open_files(working *w)
{
    int log = open_file(w->s, w->task, ".log", O_APPEND | O_CREAT | O_WRONLY);
    int fd = open_file(w->s, w->task, ".json.part",
                       O_TRUNC | O_CREAT | O_WRONLY);
    bool done = log >= 0 && fd >= 0 && dup2(log, STDOUT_FILENO) >= 0 &&
                dup2(log, STDERR_FILENO) >= 0;
    if (log >= 0)
        close(log);
    w->summary = done ? fdopen(fd, "w") : NULL;
    return w->summary != NULL;
}

static void work_locked(working *w, int fd, ovr_error *err)
{
    const ovr_study *s = w->s;
    ovr_sweep_state state = state_by_files(s, w->task);
    if (state != OVR_SWEEP_WAITING && !same_case(s, w->task, fd))
        state = OVR_SWEEP_CHANGED;
    if (!ovr_sweep_is_due(w->how, state)) /* another process has solved it
                                           * meanwhile */
        return;
    if (state != OVR_SWEEP_STOPPED || w->how->redo) {
        start_afresh(s, w->task);
        state = OVR_SWEEP_WAITING;
    }
    keep_streams(w);
    if (open_files(w)) {
        run_case(w, state == OVR_SWEEP_STOPPED && s->results, fd, err);
        fclose(w->summary);
    } else {
        err->status = OVR_IO;
    }
    restore_streams(w);
    if (!w->summary)
        return;
    if (err->status)
        discard(s, w->task, ".json.part");
    if (err->status && err->status != OVR_STOPPED)
        mark_failed(s, w->task, err->message,
                    err->status == OVR_BAD_INPUT ? 2 : 1);
}

/* ------------------------------------------------------ cases with rows */

/* Redirects standard output and error to the log of this process, after a line
 * with the name of the case. Returns the offset of that line. */
static off_t open_log(working *w, int log)
{
    char name[OVR_STUDY_NAME];
    off_t at = lseek(log, 0, SEEK_END);
    ovr_study_name(w->s, w->task, name, sizeof name);
    keep_streams(w);
    if (at < 0 || dprintf(log, "%s\n", name) < 0 ||
        dup2(log, STDOUT_FILENO) < 0 || dup2(log, STDERR_FILENO) < 0)
        return -1;
    return at;
}

/* Restores the standard streams. Removes the log's line if the case printed
 * nothing. */
static void close_log(working *w, int log, off_t at)
{
    char name[OVR_STUDY_NAME];
    restore_streams(w);
    ovr_study_name(w->s, w->task, name, sizeof name);
    if (at >= 0 && lseek(log, 0, SEEK_END) == at + (off_t)strlen(name) + 1)
        (void)!ftruncate(log, at);
}

static void keep_row(working *w, ovr_error *err)
{
    ovr_error why = {0};
    if (err->status == OVR_OK)
        ovr_rows_finish(w->rows, w->task, w->row, err);
    else if (err->status != OVR_STOPPED)
        ovr_rows_fail(w->rows, w->task, err->message, &why);
    if (err->status || w->s->results)
        return;
    discard(w->s, w->task, ".find.csv");
    if (w->s->find.how.key)
        discard(w->s, w->task, ".ini");
}

static void work_claimed(working *w, ovr_error *err)
{
    ovr_row row;
    int log = ovr_rows_log(w->rows);
    off_t at;
    ovr_sweep_state state = ovr_task_state(w->s, w->rows, w->task);
    if (!ovr_sweep_is_due(w->how, state))
        return; /* another process solves it */
    if (ovr_rows_elsewhere(w->rows, w->task) || w->how->redo ||
        (w->s->find.how.key && state != OVR_SWEEP_STOPPED))
        start_afresh(w->s, w->task);
    if (ovr_row_begin(&row, err) == OVR_OK)
        w->row = &row;
    if (w->row && log < 0) {
        ovr_fail(err, OVR_IO, "%s: no log can be written: %s", w->s->output,
                 strerror(errno));
    } else if (w->row) {
        at = open_log(w, log);
        run_case(w, false, -1, err);
        close_log(w, log, at);
    }
    keep_row(w, err);
    w->row = NULL;
    ovr_row_free(&row);
}

/* ------------------------------------------------------------------- lock */

static void warn_of_locks(working *w)
{
    forward_message(
        w, OVR_MESSAGE_WARNING,
        "this file system has no locks; do not run two sweeps of this "
        "folder at the same time");
}

/* Locks a task's file; retries because a process that reads the state may hold
 * the lock briefly. */
static bool lock(working *w, int fd)
{
    const struct timespec moment = {0, 20000000};
    int error = EWOULDBLOCK;
    for (int attempt = 0; attempt < 5 && error == EWOULDBLOCK; attempt++) {
        if (attempt)
            nanosleep(&moment, NULL);
        error = ovr_lock_file(fd, false);
    }
    if (error && error != EWOULDBLOCK)
        warn_of_locks(w);
    return error != EWOULDBLOCK;
}

static ovr_status work_in_rows(working *w)
{
    ovr_error err = {0};
    int error = ovr_rows_claim(w->rows, w->task);
    if (error == EWOULDBLOCK)
        return OVR_OK;
    if (error)
        warn_of_locks(w);
    work_claimed(w, &err);
    ovr_rows_release(w->rows, w->task);
    return err.status;
}

ovr_status ovr_task_work(const ovr_study *s, size_t task,
                         const ovr_sweep_options *how, ovr_shared shared,
                         ovr_rows *rows)
{
    working w = {s, task, how, {0}, shared, NULL, -1, -1, rows, NULL};
    ovr_error err = {0};
    if (how->run)
        w.run = *how->run;
    if (rows)
        return work_in_rows(&w);
    int fd = open_file(s, task, ".ini", O_RDWR | O_CREAT);
    if (fd < 0) {
        fail_to_write(s, task, &err);
        report(&w, NULL, &err);
        return OVR_IO;
    }
    if (lock(&w, fd))
        work_locked(&w, fd, &err);
    close(fd);
    return err.status;
}
