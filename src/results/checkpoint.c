/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/checkpoint.h"

#include <errno.h>
#include <fcntl.h>
#include <libdeflate.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/disk.h"
#include "base/given.h"
#include "overroll/version.h"
#include "results/results.h"
#include "results/store.h"
#include "simulation/simulation.h"

/* A file that is being written, with buffer and checksum. */
typedef struct sink {
    int fd, error;
    uint64_t sum;
    size_t used;
    unsigned char buffer[1 << 15];
} sink;

static void empty(sink *s)
{
    const unsigned char *next = s->buffer;
    while (!s->error && s->used > 0) {
        ssize_t n = write(s->fd, next, s->used);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0) {
            s->error = n < 0 ? errno : ENOSPC;
            return;
        }
        next += n;
        s->used -= (size_t)n;
    }
}

static void write_bytes(sink *s, const void *data, size_t bytes)
{
    const unsigned char *next = data;
    while (bytes > 0 && !s->error) {
        size_t n = sizeof s->buffer - s->used;
        if (n > bytes)
            n = bytes;
        memcpy(s->buffer + s->used, next, n);
        s->sum = libdeflate_crc32((uint32_t)s->sum, next, n);
        s->used += n;
        next += n;
        bytes -= n;
        if (s->used == sizeof s->buffer)
            empty(s);
    }
}

static void write_piece(sink *s, const char *prefix, const char *name,
                        const void *data, size_t bytes)
{
    uint64_t length[2] = {strlen(prefix) + strlen(name), bytes};
    write_bytes(s, length, sizeof length);
    write_bytes(s, prefix, strlen(prefix));
    write_bytes(s, name, strlen(name));
    write_bytes(s, data, bytes);
}

static void write_text(sink *s, const char *name, const char *text)
{
    write_piece(s, name, "", text ? text : "", text ? strlen(text) : 0);
}

static ovr_status write_state(void *context, const char *name, void *memory,
                              size_t bytes, ovr_error *err)
{
    (void)err;
    write_piece(context, "state ", name, memory, bytes);
    return OVR_OK;
}

static ovr_status write_all(sink *s, const ovr_checkpoint *c, ovr_error *err)
{
    const uint64_t order = OVR_RESTART_ORDER, format = OVR_RESTART_FORMAT;
    ovr_status status = OVR_OK;
    uint64_t sum;
    write_bytes(s, OVR_RESTART_MAGIC, OVR_RESTART_MAGIC_SIZE);
    write_bytes(s, &order, sizeof order);
    write_piece(s, "format", "", &format, sizeof format);
    write_text(s, "version", OVERROLL_VERSION);
    write_text(s, "created", c->created);
    write_text(s, "case path", c->case_path);
    write_text(s, "case text", c->case_text);
    for (size_t k = 0; k < c->value_count; k++)
        write_piece(s, c->values[k].physics ? "value +" : "value -",
                    c->values[k].name, c->values[k].text,
                    strlen(c->values[k].text));
    write_piece(s, "counts", "", &c->counts, sizeof c->counts);
    write_piece(s, "base", "", &c->number, sizeof c->number);
    if (c->source.visit_all)
        status = c->source.visit_all(c->source.object, write_state, s, err);
    sum = s->sum;
    write_piece(s, "", "", &sum, sizeof sum);
    empty(s);
    return status;
}

static ovr_status failed(const ovr_checkpoint *c, int error, ovr_error *err)
{
    char text[128] = "";
    if (strerror_r(error, text, sizeof text) != 0)
        text[0] = '\0';
    unlink(c->part);
    return ovr_fail(err, OVR_IO, "%s: cannot be written: %s", c->path, text);
}

ovr_status ovr_checkpoint_write(const ovr_checkpoint *c, ovr_error *err)
{
    sink s;
    ovr_status status;
    s.fd = open(c->part, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC,
                0666);
    if (s.fd < 0)
        return failed(c, errno, err);
    s.error = 0;
    s.sum = 0;
    s.used = 0;
    status = write_all(&s, c, err);
    if (!s.error && c->sync && fsync(s.fd) != 0)
        s.error = errno;
    if (close(s.fd) != 0 && !s.error)
        s.error = errno;
    if (status != OVR_OK) {
        unlink(c->part);
        return status;
    }
    if (s.error || rename(c->part, c->path) != 0)
        return failed(c, s.error ? s.error : errno, err);
    if (c->sync)
        s.error = ovr_sync_folder(c->path);
    return s.error ? failed(c, s.error, err) : OVR_OK;
}

/* ------------------------------------------------------------------ reading */

/* A checkpoint being read (its format: checkpoint.h). */

struct ovr_restart {
    ovr_arena arena;
    char *path;
    unsigned char *data; /* complete contents of the file */
    size_t bytes;
    size_t first_state; /* offset of the records of the state */
    const char *version, *created;
    ovr_counts counts;
    uint64_t number, format;
    ovr_restart_info info;
    ovr_case_value *values;
};

/* A record in the file's memory. */
typedef struct piece {
    const char *name;
    const unsigned char *content;
    size_t name_length, bytes;
    size_t next; /* offset of the next record */
} piece;

/* Reads the record at `at`; false if it is incomplete. */
static bool piece_at(const ovr_restart *r, size_t at, piece *p)
{
    uint64_t length[2];
    size_t left;
    if (at > r->bytes || r->bytes - at < sizeof length)
        return false;
    memcpy(length, r->data + at, sizeof length);
    at += sizeof length;
    left = r->bytes - at;
    if (length[0] == 0 || length[0] > left || length[1] > left - length[0])
        return false;
    p->name = (const char *)r->data + at;
    p->name_length = (size_t)length[0];
    p->content = r->data + at + p->name_length;
    p->bytes = (size_t)length[1];
    p->next = at + p->name_length + p->bytes;
    return true;
}

static bool is_named(const piece *p, const char *name)
{
    return p->name_length == strlen(name) &&
           memcmp(p->name, name, p->name_length) == 0;
}

static bool begins(const piece *p, const char *prefix)
{
    return p->name_length > strlen(prefix) &&
           memcmp(p->name, prefix, strlen(prefix)) == 0;
}

static const char *copy_text(ovr_restart *r, const void *text, size_t length,
                             ovr_error *err)
{
    char *copy = ovr_arena_take(&r->arena, length + 1, 1, err);
    return copy ? memcpy(copy, text, length) : NULL;
}

/* ---------------------------------------------------------------- opening */

static ovr_status refuse(const ovr_restart *r, const char *why, ovr_error *err)
{
    return ovr_fail(err, OVR_BAD_INPUT, "%s: %s", r->path, why);
}

static ovr_status read_file(ovr_restart *r, int fd, ovr_error *err)
{
    struct stat about;
    if (fstat(fd, &about) != 0 || about.st_size <= 0)
        return refuse(r, "is empty", err);
    r->bytes = (size_t)about.st_size;
    r->data = ovr_arena_take(&r->arena, r->bytes, 1, err);
    if (!r->data)
        return OVR_NO_MEMORY;
    for (size_t have = 0; have < r->bytes;) {
        ssize_t n = read(fd, r->data + have, r->bytes - have);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return refuse(r, "cannot be read", err);
        have += (size_t)n;
    }
    return OVR_OK;
}

static ovr_status load_file(ovr_restart *r, ovr_error *err)
{
    ovr_status status;
    int fd = open(r->path, O_RDONLY | O_CLOEXEC);
    if (fd < 0)
        return refuse(r, strerror(errno), err);
    status = read_file(r, fd, err);
    close(fd);
    return status;
}

/* Checks the end: a record without a name with the checksum of all preceding
 * bytes. */
static ovr_status check_whole(const ovr_restart *r, ovr_error *err)
{
    enum { HEAD = OVR_RESTART_MAGIC_SIZE + 8, END = 24 };
    const uint64_t order = OVR_RESTART_ORDER;
    const uint64_t lengths[2] = {0, 8}; /* lengths of name and content */
    uint64_t sum, found;
    if (r->bytes < HEAD + END ||
        memcmp(r->data, OVR_RESTART_MAGIC, OVR_RESTART_MAGIC_SIZE) != 0)
        return refuse(r, "is not a checkpoint of overroll", err);
    if (memcmp(r->data + OVR_RESTART_MAGIC_SIZE, &order, sizeof order) != 0)
        return refuse(r, "was written on another kind of machine", err);
    sum = libdeflate_crc32(0, r->data, r->bytes - END);
    memcpy(&found, r->data + r->bytes - 8, sizeof found);
    if (sum != found ||
        memcmp(r->data + r->bytes - END, lengths, sizeof lengths) != 0)
        return refuse(r, "is damaged (wrong checksum)", err);
    return OVR_OK;
}

static bool read_value(ovr_restart *r, const piece *p, ovr_error *err)
{
    size_t prefix = strlen("value +");
    ovr_case_value *value = &r->values[r->info.value_count++];
    value->physics = p->name[prefix - 1] == '+';
    value->number = NAN;
    value->name = copy_text(r, p->name + prefix, p->name_length - prefix, err);
    value->text = copy_text(r, p->content, p->bytes, err);
    return value->name && value->text;
}

static bool read_piece(ovr_restart *r, const piece *p, ovr_error *err)
{
    const struct {
        const char *name;
        const char **to;
    } text[] = {{"version", &r->version},
                {"created", &r->created},
                {"case path", &r->info.case_path},
                {"case text", &r->info.case_text}};
    for (size_t k = 0; k < sizeof text / sizeof *text; k++)
        if (is_named(p, text[k].name)) {
            *text[k].to = copy_text(r, p->content, p->bytes, err);
            return *text[k].to != NULL;
        }
    if (is_named(p, "counts") && p->bytes == sizeof r->counts)
        memcpy(&r->counts, p->content, sizeof r->counts);
    if (is_named(p, "format") && p->bytes == sizeof r->format)
        memcpy(&r->format, p->content, sizeof r->format);
    if (is_named(p, "base") && p->bytes == sizeof r->number)
        memcpy(&r->number, p->content, sizeof r->number);
    if (begins(p, "value "))
        return read_value(r, p, err);
    return true;
}

static size_t count_values(const ovr_restart *r, size_t at)
{
    piece p;
    size_t count = 0;
    for (; piece_at(r, at, &p); at = p.next)
        count += begins(&p, "value ");
    return count;
}

static bool find_state(const ovr_restart *r, const char *name, piece *p)
{
    const size_t prefix = strlen("state ");
    for (size_t at = r->first_state; piece_at(r, at, p); at = p->next)
        if (p->name_length == prefix + strlen(name) &&
            memcmp(p->name + prefix, name, strlen(name)) == 0)
            return true;
    return false;
}

static void read_domain(ovr_restart *r)
{
    ovr_restart_info *info = &r->info;
    piece p;
    info->inlet = info->outlet = NAN;
    if (find_state(r, "inlet", &p) && p.bytes == sizeof info->inlet)
        memcpy(&info->inlet, p.content, sizeof info->inlet);
    if (find_state(r, "outlet", &p) && p.bytes == sizeof info->outlet)
        memcpy(&info->outlet, p.content, sizeof info->outlet);
    if (find_state(r, "level", &p) && p.bytes == sizeof info->level)
        memcpy(&info->level, p.content, sizeof info->level);
}

static ovr_status read_pieces(ovr_restart *r, ovr_error *err)
{
    size_t at = OVR_RESTART_MAGIC_SIZE + 8;
    piece p;
    r->format = 1;
    r->version = r->created = r->info.case_path = r->info.case_text = "";
    r->values = ovr_arena_take(&r->arena, count_values(r, at),
                               sizeof *r->values, err);
    if (!r->values)
        return OVR_NO_MEMORY;
    for (; piece_at(r, at, &p) && !begins(&p, "state "); at = p.next)
        if (!read_piece(r, &p, err))
            return OVR_NO_MEMORY;
    r->first_state = at;
    r->info.has_state = piece_at(r, at, &p);
    read_domain(r);
    r->info.values = r->values;
    r->info.step = (long)r->counts.step;
    r->info.T = r->counts.T;
    r->info.snapshots = (size_t)r->counts.snapshots;
    r->info.steps = (size_t)r->counts.steps;
    return OVR_OK;
}

/* Compares major and minor version: "0.4.1" continues a run of "0.4.0". */
static bool is_same_minor(const char *version)
{
    const char *dot = strchr(OVERROLL_VERSION, '.');
    size_t length = (size_t)(strchr(dot + 1, '.') - OVERROLL_VERSION) + 1;
    return strncmp(version, OVERROLL_VERSION, length) == 0;
}

/* Rejects a checkpoint of another minor version, which may have other defaults
 * and another state. */
static ovr_status check_format(const ovr_restart *r, ovr_error *err)
{
    if (r->format > OVR_RESTART_FORMAT || !is_same_minor(r->version))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: was written by overroll %s in format %llu, "
                        "which overroll %s cannot resume; run the case again",
                        r->path, r->version, (unsigned long long)r->format,
                        OVERROLL_VERSION);
    if (r->counts.snapshots < 0 || r->counts.steps < 0)
        return refuse(r, "is damaged (negative counts)", err);
    return OVR_OK;
}

ovr_restart *ovr_restart_open(const char *result_path,
                              const ovr_allocator *allocator, ovr_error *err)
{
    if (!result_path)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_restart *r = ovr_arena_take(&arena, 1, sizeof *r, err);
    if (!r)
        return NULL;
    r->arena = arena;
    r->path = ovr_path_with(&r->arena, result_path, ".restart", err);
    if (!r->path || load_file(r, err) || check_whole(r, err) ||
        read_pieces(r, err) || check_format(r, err)) {
        ovr_restart_close(r);
        return NULL;
    }
    return r;
}

void ovr_restart_close(ovr_restart *r)
{
    if (r) {
        ovr_arena arena = r->arena;
        ovr_arena_release(&arena);
    }
}

/* ------------------------------------------------------------------ using */

const ovr_restart_info *ovr_restart_get_info(const ovr_restart *r)
{
    return !r ? NULL : &r->info;
}

const char *ovr_restart_created(const ovr_restart *r)
{
    return r->created;
}

const ovr_counts *ovr_restart_counts(const ovr_restart *r)
{
    return &r->counts;
}

uint64_t ovr_restart_number(const ovr_restart *r)
{
    return r->number;
}

static const ovr_case_value *find(const ovr_case_value *list, size_t count,
                                  const char *name)
{
    for (size_t k = 0; k < count; k++)
        if (strcmp(list[k].name, name) == 0)
            return &list[k];
    return NULL;
}

static ovr_status differs(const ovr_case_value *was, const ovr_case_value *is,
                          ovr_error *err)
{
    return ovr_fail(err, OVR_BAD_INPUT,
                    "'%s' was '%s' and is now '%s'; a resumed run must have "
                    "the same case",
                    was ? was->name : is->name, was ? was->text : "not there",
                    is ? is->text : "not there");
}

ovr_status ovr_values_same(size_t were, const ovr_case_value *was, size_t count,
                           const ovr_case_value *values, ovr_error *err)
{
    for (size_t k = 0; k < were; k++) {
        const ovr_case_value *is = find(values, count, was[k].name);
        if (was[k].physics && (!is || strcmp(was[k].text, is->text) != 0))
            return differs(&was[k], is, err);
    }
    for (size_t k = 0; k < count; k++)
        if (values[k].physics && !find(was, were, values[k].name))
            return differs(NULL, &values[k], err);
    return OVR_OK;
}

typedef struct getting {
    ovr_restart *restart;
    bool write; /* write values; otherwise only check that all fit */
} getting;

/* Reads a value of the state. A number missing in the checkpoint keeps its
 * value. */
static ovr_status get_state(void *context, const char *name, void *memory,
                            size_t bytes, ovr_error *err)
{
    const getting *get = context;
    piece p;
    bool found = find_state(get->restart, name, &p);
    if (!found && bytes <= sizeof(double))
        return OVR_OK;
    if (!found || p.bytes != bytes)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: does not belong to this simulation ('%s' "
                        "differs)",
                        get->restart->path, name);
    if (get->write)
        memcpy(memory, p.content, bytes);
    return OVR_OK;
}

/* Loads the state. A first pass checks that all records fit, so that no state
 * is partly loaded. */
ovr_status ovr_restart_load_into(ovr_restart *r, const ovr_state_source *source,
                                 ovr_error *err)
{
    getting look = {r, false}, take = {r, true};
    ovr_status status = source->visit_all(source->object, get_state, &look,
                                          err);
    if (status != OVR_OK)
        return status;
    return source->visit_all(source->object, get_state, &take, err);
}

bool ovr_restart_holds(const ovr_restart *r, const char *name,
                       const void *memory, size_t bytes)
{
    piece p;
    return find_state(r, name, &p) && p.bytes == bytes &&
           memcmp(p.content, memory, bytes) == 0;
}
