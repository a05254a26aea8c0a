/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the input files that a result file holds. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "results/inputs.h"
#include "results/reader.h"

enum { INPUTS_MAX = 4096, CHUNK = 1 << 16 };

static const char *or_empty(const char *text)
{
    return text ? text : "";
}

/* False: the object is no dataset, or not that of an input. */
static bool describe(ovr_result *r, const ovr_link *link, ovr_result_input *to)
{
    ovr_container *c = &r->container;
    ovr_dataset set;
    const char *name = ovr_reader_text(r, link->object, "name");
    if (!name || !ovr_container_dataset(c, link->object, &set) || set.rank != 1)
        return false;
    double bytes = ovr_container_number(c, link->object, "bytes");
    *to = (ovr_result_input){
        .key = or_empty(ovr_reader_text(r, link->object, "key")),
        .name = name,
        .sha256 = or_empty(ovr_reader_text(r, link->object, "sha256")),
        .bytes = bytes,
        .kept = bytes >= 0 && bytes <= OVR_INPUT_MAX &&
                (double)set.shape[0] == bytes && set.element.kind == 'i' &&
                set.element.size == 1};
    return true;
}

ovr_status ovr_reader_inputs(ovr_result *r, ovr_error *err)
{
    ovr_container *c = &r->container;
    uint64_t group;
    size_t count;
    r->inputs = 0;
    if (!ovr_container_find(c, c->root, "inputs", &group))
        return OVR_OK;
    ovr_link *links = ovr_container_links(c, group, &count);
    if (!links || count > INPUTS_MAX)
        return ovr_fail(err, OVR_IO, "%s: damaged result file: inputs",
                        r->path);
    r->input = ovr_arena_take(&r->arena, count, sizeof *r->input, err);
    r->input_path = ovr_arena_take(&r->arena, count, sizeof *r->input_path,
                                   err);
    if (!r->input || !r->input_path)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < count; k++) {
        char path[80];
        snprintf(path, sizeof path, "inputs/%s", links[k].name);
        r->input_path[r->inputs] = ovr_arena_text(&r->arena, path, err);
        if (!r->input_path[r->inputs])
            return OVR_NO_MEMORY;
        r->inputs += describe(r, &links[k], &r->input[r->inputs]);
    }
    return OVR_OK;
}

const ovr_result_input *ovr_result_input_at(const ovr_result *r, size_t k)
{
    return r && k < r->inputs ? &r->input[k] : NULL;
}

/* ------------------------------------------------------------------ Reading */

/* Opens the file unless it is open; the lock is held until `leave`. */
static bool enter(ovr_result *r, int *lock)
{
    *lock = ovr_reader_lock(r);
    if (*lock >= 0)
        ovr_reader_close_file(r);
    return r->fd >= 0 || ovr_reader_file(r, *lock, NULL) == OVR_OK;
}

static void leave(ovr_result *r, int lock)
{
    ovr_reader_unlock(lock);
    ovr_arena_release(&r->work);
}

static bool read_bytes(ovr_result *r, size_t k, unsigned char *bytes)
{
    size_t size = (size_t)r->input[k].bytes;
    ovr_dataset set;
    if (!ovr_reader_dataset(r, r->input_path[k], &set) || set.rank != 1 ||
        set.shape[0] != size)
        return false;
    double *values = ovr_arena_take(&r->work, CHUNK, sizeof *values, NULL);
    for (size_t at = 0; values && at < size; at += CHUNK) {
        size_t n = size - at < CHUNK ? size - at : CHUNK;
        if (!ovr_container_values(&r->container, &set, at, n, values))
            return false;
        for (size_t i = 0; i < n; i++)
            bytes[at + i] = (unsigned char)(int)values[i];
    }
    return values != NULL;
}

ovr_status ovr_result_input_read(ovr_result *r, size_t k, unsigned char *bytes,
                                 ovr_error *err)
{
    if (!r || !bytes)
        return ovr_fail_null(err, __func__);
    if (k >= r->inputs || !r->input[k].kept)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: does not hold input %zu",
                        r->path, k + 1);
    const ovr_result_input *input = &r->input[k];
    int lock;
    bool ok = enter(r, &lock) && read_bytes(r, k, bytes);
    leave(r, lock);
    if (ok &&
        !strcmp(ovr_sha256_of(bytes, (size_t)input->bytes).text, input->sha256))
        return OVR_OK;
    return ovr_fail(err, OVR_IO,
                    ok ? "%s: its copy of '%.200s' does not have the SHA-256 "
                         "of that file: the result file is damaged"
                       : "%s: its copy of '%.200s' cannot be read: the result "
                         "file is damaged",
                    r->path, input->name);
}

/* The place of a dataset in the list of inputs. */
static size_t find(const ovr_result *r, const char *name)
{
    size_t k = 0;
    while (k < r->inputs &&
           strcmp(r->input_path[k] + strlen("inputs/"), name) != 0)
        k++;
    return k;
}

size_t ovr_result_input_of(ovr_result *r, const char *key)
{
    size_t found = r->inputs;
    uint64_t group;
    int lock;
    if (enter(r, &lock) && ovr_reader_object(r, "inputs", &group)) {
        const char *name = ovr_container_text(&r->container, group, key);
        found = name ? find(r, name) : r->inputs;
    }
    leave(r, lock);
    return found;
}
