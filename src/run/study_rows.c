/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/study_rows.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/disk.h"
#include "base/lock.h"
#include "base/text.h"
#include "overroll/text.h"
#include "run/csv.h"
#include "run/run.h"

enum {
    PATH_CAPACITY = 4400,
    HEADER = 64, /* bytes of the index's header; one record per case follows */
    RECORD = 24,
    COLUMNS = 256, /* maximum number of columns */
    LINE = 1 << 16,
    FILES = 100000
};

static const char first_columns[] = "name,case,status,message,time";
enum { FIRST_COLUMNS = 5 };

/* A table opened for reading. */
typedef struct table {
    FILE *from;
    char *head; /* split into column names */
    const char *column[COLUMNS];
    size_t columns;
} table;

struct ovr_rows {
    ovr_arena arena;
    const ovr_study *s;
    int index, out, log;
    unsigned number;   /* number N of the table cases-N.csv that is appended
                        * to */
    char *head, *line; /* head of this table; buffer for a row */
    char *records;     /* all records if `whole`, otherwise NULL */
    table **table;     /* table of each number, or NULL if not read yet */
    size_t tables;
    time_t synced;
};

/* ------------------------------------------------------------------- Index */

/*
 * Record of a case: "f0000012 00000000123456
 * ", or zeros if the case waits.
 */
typedef struct record {
    char state; /* f finished, x failed, c changed, o result in files of its
                 * own */
    unsigned file;
    uint64_t at;
} record;

static void write_record_text(char text[RECORD + 1], record r)
{
    snprintf(text, RECORD + 1, "%c%07u %014" PRIu64 "\n", r.state, r.file,
             r.at);
}

static record get_record(const char *text)
{
    char copy[RECORD + 1], *next, *end;
    record r = {text[0], 0, 0};
    memcpy(copy, text, RECORD);
    copy[RECORD] = '\0';
    r.file = (unsigned)strtoul(copy + 1, &next, 10);
    r.at = strtoull(next, &end, 10);
    return r.state && next > copy + 1 && end > next && *end == '\n'
               ? r
               : (record){0};
}

static uint64_t place_of(size_t task)
{
    return HEADER + (uint64_t)task * RECORD;
}

static void write_header(const ovr_study *s, char text[HEADER + 1])
{
    char line[HEADER + 1];
    snprintf(line, sizeof line, "overroll study 1 %016" PRIx64 " %zu",
             s->signature, s->tasks);
    snprintf(text, HEADER + 1, "%-63.63s\n", line);
}

/* False if the index is missing or belongs to another version of the study. */
static bool is_current(const ovr_rows *r)
{
    char wanted[HEADER + 1], found[HEADER];
    write_header(r->s, wanted);
    return ovr_read_all(r->index, found, HEADER, 0) == 0 &&
           !memcmp(found, wanted, HEADER);
}

static record record_of(const ovr_rows *r, size_t task)
{
    char text[RECORD];
    if (r->records)
        return get_record(r->records + (size_t)RECORD * task);
    if (r->index < 0 ||
        ovr_read_all(r->index, text, RECORD, place_of(task)) != 0)
        return (record){0};
    return get_record(text);
}

/* Writes a record, unless the index now belongs to another version of the
 * study, which will find the row in its table. */
static int write_record(ovr_rows *r, size_t task, record what)
{
    char text[RECORD + 1] = {0};
    if (what.state)
        write_record_text(text, what);
    if (r->records)
        memcpy(r->records + (size_t)RECORD * task, text, RECORD);
    return is_current(r) ? ovr_write_all(r->index, text, RECORD, place_of(task))
                         : 0;
}

/* ------------------------------------------------------------------ Tables */

static void path_of(const ovr_study *s, const char *ending, unsigned number,
                    char *path, size_t capacity)
{
    snprintf(path, capacity, "%s/cases-%u.%s", s->output, number, ending);
}

static table *open_table(ovr_rows *r, unsigned number)
{
    char path[PATH_CAPACITY], *at;
    bool last = false;
    if (number >= r->tables) {
        size_t count = 2 * (size_t)number + 8;
        table **more = ovr_arena_take(&r->arena, count, sizeof *more, NULL);
        if (!more)
            return NULL;
        if (r->tables)
            memcpy(more, r->table, r->tables * sizeof *more);
        r->table = more;
        r->tables = count;
    }
    table *t = r->table[number];
    if (t)
        return t;
    path_of(r->s, "csv", number, path, sizeof path);
    FILE *from = fopen(path, "r");
    t = from ? ovr_arena_take(&r->arena, 1, sizeof *t, NULL) : NULL;
    if (from && !t)
        fclose(from);
    if (!t)
        return NULL;
    t->from = from;
    r->table[number] = t;
    if (fgets(r->line, LINE, t->from) &&
        !strncmp(r->line, first_columns, sizeof first_columns - 1))
        t->head = at = ovr_arena_text(&r->arena, r->line, NULL);
    for (size_t k = 0; t->head && !last && k < COLUMNS; k++) {
        t->column[k] = ovr_csv_cell(&at, &last);
        t->columns = k + 1;
    }
    return t;
}

/* Parses a line as a row; false if it is truncated or malformed. */
static bool is_row(const char *line)
{
    size_t length = strlen(line), commas = 0;
    for (const char *c = line; *c; c++)
        commas += *c == ',';
    return length && line[length - 1] == '\n' && commas >= FIRST_COLUMNS - 1;
}

/* Returns the row of a case, in r->line; NULL if it was destroyed. */
static char *row_of(ovr_rows *r, size_t task, const table **of)
{
    record place = record_of(r, task);
    char name[OVR_STUDY_NAME];
    size_t length;
    if (place.state != 'f' && place.state != 'x')
        return NULL;
    table *t = open_table(r, place.file);
    if (!t || !t->head || fseeko(t->from, (off_t)place.at, SEEK_SET) != 0 ||
        !fgets(r->line, LINE, t->from) || !is_row(r->line))
        return NULL;
    ovr_study_name(r->s, task, name, sizeof name);
    length = strlen(name);
    if (strncmp(r->line, name, length) != 0 || r->line[length] != ',')
        return NULL;
    *of = t;
    return r->line;
}

/* ------------------------------------------- The index made from the tables */

/* Hash of a case's name, used to find the case of a row. */
typedef struct named {
    uint64_t hash;
    size_t task;
} named;

static int by_hash(const void *a, const void *b)
{
    const named *x = a, *y = b;
    return (x->hash > y->hash) - (x->hash < y->hash);
}

static named *name_all(const ovr_study *s, ovr_arena *arena)
{
    named *all = ovr_arena_take(arena, s->tasks, sizeof *all, NULL);
    for (size_t i = 0; all && i < s->tasks; i++) {
        char name[OVR_STUDY_NAME];
        ovr_study_name(s, i, name, sizeof name);
        all[i] = (named){ovr_text_hash(name), i};
    }
    if (all)
        qsort(all, s->tasks, sizeof *all, by_hash);
    return all;
}

typedef struct rebuilding {
    ovr_rows *r;
    ovr_arena arena;
    named *all;
    double *time; /* time stamp of the row of each case */
} rebuilding;

/* Stores the position of a row; the newest row of a case is used. */
static void index_row(rebuilding *b, char *line, unsigned file, uint64_t at)
{
    char *rest = line, *cell[FIRST_COLUMNS], text[RECORD + 1];
    bool last = false;
    const char *number;
    double time = 0;
    if (!is_row(line))
        return;
    for (int k = 0; k < FIRST_COLUMNS; k++)
        cell[k] = last ? "" : ovr_csv_cell(&rest, &last);
    named key = {ovr_text_hash(cell[0]), 0};
    const named *found = bsearch(&key, b->all, b->r->s->tasks, sizeof key,
                                 by_hash);
    number = cell[4];
    if (!found || !ovr_read_number(&number, &time))
        return;
    bool same = strtoull(cell[1], NULL, 16) ==
                ovr_study_identity(b->r->s, found->task);
    char *to = b->r->records + (size_t)RECORD * found->task;
    bool known = *to == 'f' || *to == 'x';
    if (known ? !same || time < b->time[found->task] : *to && !same)
        return;
    b->time[found->task] = time;
    write_record_text(text, (record){!same                          ? 'c'
                                     : !strcmp(cell[2], "finished") ? 'f'
                                                                    : 'x',
                                     file, at});
    memcpy(to, text, RECORD);
}

static void index_table(rebuilding *b, unsigned number)
{
    table *t = open_table(b->r, number);
    while (t && t->head) {
        uint64_t at = (uint64_t)ftello(t->from);
        if (!fgets(b->r->line, LINE, t->from))
            break;
        index_row(b, b->r->line, number, at);
    }
}

static bool ends_with(const char *name, const char *ending)
{
    size_t n = strlen(name), m = strlen(ending);
    return n > m && !strcmp(name + n - m, ending);
}

/* Marks cases with result files of their own, as studies with result files
 * write. */
static void index_files(rebuilding *b)
{
    const ovr_study *s = b->r->s;
    for (size_t i = 0; i < s->tasks; i++) {
        char path[PATH_CAPACITY], text[RECORD + 1], *to;
        bool found = false;
        to = b->r->records + (size_t)RECORD * i;
        ovr_study_file(s, i, ".json", path, sizeof path);
        found = access(path, F_OK) == 0;
        ovr_study_file(s, i, ".h5", path, sizeof path);
        found = found && access(path, F_OK) == 0;
        ovr_study_file(s, i, ".failed", path, sizeof path);
        found = found || access(path, F_OK) == 0;
        if (!found || *to)
            continue;
        write_record_text(text, (record){'o', 0, 0});
        memcpy(to, text, RECORD);
    }
}

/* Returns N of "cases-N.csv", 0 for other names. */
static unsigned number_in(const char *name)
{
    static const char begin[] = "cases-";
    const char *digits = name + sizeof begin - 1;
    char *end;
    if (strncmp(name, begin, sizeof begin - 1) != 0 || *digits < '1' ||
        *digits > '9')
        return 0;
    unsigned long number = strtoul(digits, &end, 10);
    return number < FILES && !strcmp(end, ".csv") ? (unsigned)number : 0;
}

static ovr_status read_folder(rebuilding *b)
{
    DIR *folder = opendir(b->r->s->output);
    struct dirent *entry;
    bool files = false;
    while (folder && (entry = readdir(folder))) {
        unsigned number = number_in(entry->d_name);
        files = files || ends_with(entry->d_name, ".json") ||
                ends_with(entry->d_name, ".failed");
        if (!number)
            continue;
        if (!b->all && !(b->all = name_all(b->r->s, &b->arena)))
            return OVR_NO_MEMORY;
        index_table(b, number);
    }
    if (folder)
        closedir(folder);
    if (files)
        index_files(b);
    return OVR_OK;
}

static ovr_status make_records(ovr_rows *r, ovr_error *err)
{
    const size_t n = r->s->tasks;
    rebuilding b = {.r = r, .arena = ovr_arena_make(&r->s->arena.allocator)};
    b.time = ovr_arena_take(&b.arena, n, sizeof *b.time, err);
    r->records = ovr_arena_take(&r->arena, n, RECORD, err);
    ovr_status status = b.time && r->records ? read_folder(&b) : OVR_NO_MEMORY;
    ovr_arena_release(&b.arena);
    return status;
}

/* Writes the index, the header last: after a crash before that no index is
 * valid. */
static ovr_status write_index(ovr_rows *r, ovr_error *err)
{
    char header[HEADER + 1] = {0};
    const size_t bytes = (size_t)RECORD * r->s->tasks;
    int error = ovr_write_all(r->index, header, HEADER, 0);
    write_header(r->s, header);
    if (!error && ftruncate(r->index, HEADER) != 0)
        error = errno;
    for (size_t at = 0, n; !error && at < bytes; at += n) {
        n = bytes - at < LINE ? bytes - at : LINE;
        const char *from = r->records + at;
        bool empty = !from[0] && !memcmp(from, from + 1, n - 1);
        if (!empty)
            error = ovr_write_all(r->index, from, n, HEADER + at);
    }
    if (!error)
        error = ovr_write_all(r->index, header, HEADER, 0);
    return error
               ? ovr_fail(err, OVR_IO, "%s/cases.index: cannot be written: %s",
                          r->s->output, strerror(error))
               : OVR_OK;
}

static ovr_status make_index(ovr_rows *r, ovr_error *err)
{
    ovr_status status = OVR_OK;
    ovr_lock_bytes(r->index, 0, HEADER, true);
    if (!is_current(r)) { /* no other process has written it meanwhile */
        status = make_records(r, err);
        if (!status)
            status = write_index(r, err);
    }
    ovr_unlock_bytes(r->index, 0, HEADER);
    return status;
}

static ovr_status load_index(ovr_rows *r, ovr_error *err)
{
    const size_t n = r->s->tasks;
    r->records = ovr_arena_take(&r->arena, n, RECORD, err);
    if (!r->records)
        return OVR_NO_MEMORY;
    ovr_read_all(r->index, r->records, n * RECORD, HEADER);
    return OVR_OK;
}

/* ---------------------------------------------------------- Open and close */

ovr_rows *ovr_rows_open(const ovr_study *s, bool whole, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(&s->arena.allocator);
    ovr_rows *r = ovr_arena_take(&arena, 1, sizeof *r, err);
    char path[PATH_CAPACITY];
    ovr_status status = OVR_OK;
    if (!r)
        return NULL;
    *r = (ovr_rows){.arena = arena, .s = s, .out = -1, .log = -1};
    r->line = ovr_arena_take(&r->arena, LINE, 1, err);
    snprintf(path, sizeof path, "%s/cases.index", s->output);
    r->index = open(path, O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (!r->line)
        status = OVR_NO_MEMORY;
    else if (r->index < 0) /* folder is read-only or missing */
        status = make_records(r, err);
    else if (!is_current(r))
        status = make_index(r, err);
    if (r->index >= 0 && !whole)
        r->records = NULL; /* other processes may change the file */
    if (!status && whole && !r->records)
        status = load_index(r, err);
    if (!status)
        return r;
    ovr_rows_close(r);
    return NULL;
}

void ovr_rows_close(ovr_rows *r)
{
    if (!r)
        return;
    for (size_t k = 0; k < r->tables; k++)
        if (r->table[k])
            fclose(r->table[k]->from);
    if (r->index >= 0)
        close(r->index);
    if (r->out >= 0)
        close(r->out);
    if (r->log >= 0)
        close(r->log);
    ovr_arena arena = r->arena;
    ovr_arena_release(&arena);
}

/* ------------------------------------------------------------------ States */

ovr_sweep_state ovr_rows_state(const ovr_rows *r, size_t task)
{
    char state = record_of(r, task).state;
    if (r->index >= 0 && ovr_bytes_locked(r->index, place_of(task), 1))
        return OVR_SWEEP_RUNNING;
    switch (state) {
    case 'f': return OVR_SWEEP_FINISHED;
    case 'x': return OVR_SWEEP_FAILED;
    case 'c': return OVR_SWEEP_CHANGED;
    default: return OVR_SWEEP_WAITING;
    }
}

bool ovr_rows_elsewhere(const ovr_rows *r, size_t task)
{
    return record_of(r, task).state == 'o';
}

int ovr_rows_claim(ovr_rows *r, size_t task)
{
    return ovr_lock_bytes(r->index, place_of(task), 1, false);
}

void ovr_rows_release(ovr_rows *r, size_t task)
{
    ovr_unlock_bytes(r->index, place_of(task), 1);
}

/* -------------------------------------------------------------------- Rows */

ovr_status ovr_row_begin(ovr_row *row, ovr_error *err)
{
    *row = (ovr_row){{NULL}, {NULL}, {0}};
    for (int k = 0; k < 2; k++)
        row->to[k] = open_memstream(&row->text[k], &row->size[k]);
    return row->to[0] && row->to[1]
               ? OVR_OK
               : ovr_fail(err, OVR_NO_MEMORY, "out of memory");
}

static void close_row(ovr_row *row)
{
    for (int k = 0; k < 2; k++)
        if (row->to[k])
            fclose(row->to[k]);
    row->to[0] = row->to[1] = NULL;
}

void ovr_row_free(ovr_row *row)
{
    close_row(row);
    free(row->text[0]);
    free(row->text[1]);
}

void ovr_row_add(void *data, const ovr_summary_line *line)
{
    ovr_row *row = data;
    FILE *value = row->to[1];
    if (!line->key || line->form > OVR_SUMMARY_FLAG)
        return;
    fprintf(row->to[0], ",%s", line->key);
    if (line->form == OVR_SUMMARY_COUNT)
        fprintf(value, ",%lld", (long long)line->number);
    else if (line->form == OVR_SUMMARY_FLAG)
        fprintf(value, ",%d", line->number > 0);
    else if (isfinite(line->number))
        fprintf(value, ",%.17g", line->number);
    else
        fputc(',', value);
}

/* Removes an incomplete last row left by a crash. Returns the end of the file;
 * -1 with errno. */
static off_t end_of(int fd)
{
    off_t end = lseek(fd, 0, SEEK_END), whole = end;
    char byte = '\n';
    while (whole > 0 && pread(fd, &byte, 1, whole - 1) == 1 && byte != '\n')
        whole--;
    return whole == end || ftruncate(fd, whole) == 0 ? whole : -1;
}

/* True if the table is new or has this header. Rows of failed cases fit any
 * table. */
static bool has_head(int fd, const char *head, char *line)
{
    size_t length = strlen(head);
    bool any = !strcmp(head, first_columns);
    ssize_t n = pread(fd, line, length + 1, 0);
    if (n == 0)
        return dprintf(fd, "%s\n", head) == (int)length + 1;
    return n == (ssize_t)length + 1 && !memcmp(line, head, length) &&
           (any || line[length] == '\n');
}

/* Opens and locks the first file cases-N.ENDING not used by another process. */
static int open_free(ovr_rows *r, const char *ending, const char *head,
                     unsigned *number)
{
    for (unsigned k = 1; k < FILES; k++) {
        char path[PATH_CAPACITY];
        path_of(r->s, ending, k, path, sizeof path);
        int fd = open(
            path, O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (fd < 0 && errno != ELOOP)
            return -1;
        if (fd >= 0 && ovr_lock_file(fd, false) != EWOULDBLOCK &&
            (!head || has_head(fd, head, r->line))) {
            *number = k;
            return fd;
        }
        if (fd >= 0)
            close(fd);
    }
    errno = EMFILE;
    return -1;
}

static bool fits(const ovr_rows *r, const char *head)
{
    return r->out >= 0 &&
           (!strcmp(head, first_columns) || !strcmp(head, r->head));
}

/* Appends a row and then writes its record. */
static ovr_status append(ovr_rows *r, size_t task, char state, const char *head,
                         const char *row, ovr_error *err)
{
    const size_t length = strlen(row);
    char path[PATH_CAPACITY];
    off_t at = -1;
    int error = 0;
    if (!fits(r, head)) {
        if (r->out >= 0)
            close(r->out);
        r->out = open_free(r, "csv", head, &r->number);
        r->head = ovr_arena_text(&r->arena, head, NULL);
    }
    errno = 0;
    if (r->out >= 0 && r->head)
        at = end_of(r->out);
    if (at < 0 || write(r->out, row, length) != (ssize_t)length)
        error = errno ? errno : ENOSPC;
    if (!error && time(NULL) > r->synced) { /* at most once per second */
        fdatasync(r->out);
        r->synced = time(NULL);
    }
    if (!error)
        error = write_record(r, task, (record){state, r->number, (uint64_t)at});
    path_of(r->s, "csv", r->number, path, sizeof path);
    return error ? ovr_fail(err, OVR_IO, "%s: cannot be written: %s", path,
                            strerror(error))
                 : OVR_OK;
}

static void write_first(const ovr_rows *r, size_t task, const char *status,
                        const char *message, FILE *row)
{
    char name[OVR_STUDY_NAME];
    ovr_study_name(r->s, task, name, sizeof name);
    fprintf(row, "%s,%016" PRIx64 ",%s,", name, ovr_study_identity(r->s, task),
            status);
    ovr_csv_text(row, message);
    fprintf(row, ",%lld", (long long)time(NULL));
}

/* Appends the first columns and, unless the case failed, its numbers. */
static ovr_status add_row(ovr_rows *r, size_t task, ovr_row *numbers,
                          const char *message, ovr_error *err)
{
    ovr_row whole;
    ovr_status status = ovr_row_begin(&whole, err);
    if (numbers)
        close_row(numbers);
    if (!status) {
        fputs(first_columns, whole.to[0]);
        write_first(r, task, numbers ? "finished" : "failed", message,
                    whole.to[1]);
        for (int k = 0; numbers && k < 2; k++)
            fputs(numbers->text[k], whole.to[k]);
        fputc('\n', whole.to[1]);
        close_row(&whole);
        status = append(r, task, numbers ? 'f' : 'x', whole.text[0],
                        whole.text[1], err);
    }
    ovr_row_free(&whole);
    return status;
}

ovr_status ovr_rows_finish(ovr_rows *r, size_t task, ovr_row *row,
                           ovr_error *err)
{
    return add_row(r, task, row, "", err);
}

ovr_status ovr_rows_fail(ovr_rows *r, size_t task, const char *message,
                         ovr_error *err)
{
    char line[1100];
    snprintf(line, sizeof line, "%s", message);
    for (char *c = line; *c; c++)
        if (*c == '\n' || *c == '\r')
            *c = ' ';
    return add_row(r, task, NULL, line, err);
}

int ovr_rows_log(ovr_rows *r)
{
    unsigned number;
    if (r->log < 0)
        r->log = open_free(r, "log", NULL, &number);
    return r->log;
}

/* ----------------------------------------------------------------- Reading */

bool ovr_rows_read(ovr_rows *r, size_t task, ovr_rows_number *number,
                   void *data)
{
    const table *t;
    char *at = row_of(r, task, &t);
    bool last = false;
    if (!at && !ovr_arena_status(&r->arena))
        write_record(r, task, (record){0});
    if (!at)
        return false;
    for (size_t k = 0; k < t->columns && !last; k++) {
        const char *cell = ovr_csv_cell(&at, &last);
        double value = NAN;
        if (k < FIRST_COLUMNS)
            continue;
        if (*cell)
            ovr_read_number(&cell, &value);
        number(data, t->column[k], value);
    }
    return true;
}

void ovr_rows_message(ovr_rows *r, size_t task, char *text, size_t capacity)
{
    const table *t;
    char *at = record_of(r, task).state == 'x' ? row_of(r, task, &t) : NULL;
    const char *cell = "";
    bool last = false;
    for (int k = 0; at && !last && k < 4; k++)
        cell = ovr_csv_cell(&at, &last);
    snprintf(text, capacity, "%s", cell);
}

void ovr_rows_table(const ovr_rows *r, size_t task, char *text, size_t capacity)
{
    record place = record_of(r, task);
    text[0] = '\0';
    if (place.state == 'f')
        snprintf(text, capacity, "cases-%u.csv", place.file);
}
