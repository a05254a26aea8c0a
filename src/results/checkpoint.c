/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/checkpoint.h"

#include <errno.h>
#include <fcntl.h>
#include <libdeflate.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/disk.h"
#include "overroll/version.h"

/* A file being written, through a buffer, with its checksum. */
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

static void put(sink *s, const void *data, size_t bytes)
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

static void put_piece(sink *s, const char *prefix, const char *name,
                      const void *data, size_t bytes)
{
    uint64_t length[2] = {strlen(prefix) + strlen(name), bytes};
    put(s, length, sizeof length);
    put(s, prefix, strlen(prefix));
    put(s, name, strlen(name));
    put(s, data, bytes);
}

static void put_text(sink *s, const char *name, const char *text)
{
    put_piece(s, name, "", text ? text : "", text ? strlen(text) : 0);
}

static ovr_status put_state(void *context, const char *name, void *memory,
                            size_t bytes, ovr_error *err)
{
    (void)err;
    put_piece(context, "state ", name, memory, bytes);
    return OVR_OK;
}

static ovr_status put_all(sink *s, const ovr_checkpoint *c, ovr_error *err)
{
    const uint64_t order = OVR_RESTART_ORDER, format = OVR_RESTART_FORMAT;
    ovr_status status = OVR_OK;
    uint64_t sum;
    put(s, OVR_RESTART_MAGIC, OVR_RESTART_MAGIC_SIZE);
    put(s, &order, sizeof order);
    put_piece(s, "format", "", &format, sizeof format);
    put_text(s, "version", OVERROLL_VERSION);
    put_text(s, "created", c->created);
    put_text(s, "case path", c->case_path);
    put_text(s, "case text", c->case_text);
    for (size_t k = 0; k < c->value_count; k++)
        put_piece(s, c->values[k].physics ? "value +" : "value -",
                  c->values[k].name, c->values[k].text,
                  strlen(c->values[k].text));
    put_piece(s, "counts", "", &c->counts, sizeof c->counts);
    put_piece(s, "base", "", &c->number, sizeof c->number);
    if (c->source.visit_all)
        status = c->source.visit_all(c->source.object, put_state, s, err);
    sum = s->sum;
    put_piece(s, "", "", &sum, sizeof sum);
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
    status = put_all(&s, c, err);
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
