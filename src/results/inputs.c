/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes the group `inputs` of a result file, and compares it with the files of
 * a run that is resumed. */
#include "results/inputs.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <nettle/sha2.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/given.h"
#include "results/h5.h"
#include "results/header.h"
#include "results/reader.h"

enum { CHUNK = 1 << 16 };

/* Contents of an input file; `bytes` is NULL if they are not stored. */
typedef struct content {
    unsigned char *bytes;
    uint64_t size;
    bool ordinary; /* a regular file, which can be read twice */
    ovr_sha256 sum;
} content;

static ovr_sha256 finish(struct sha256_ctx *context)
{
    uint8_t sum[SHA256_DIGEST_SIZE];
    ovr_sha256 to = {""};
    sha256_digest(context, sizeof sum, sum);
    for (size_t k = 0; k < sizeof sum; k++)
        snprintf(to.text + 2 * k, 3, "%02x", sum[k]);
    return to;
}

static ovr_sha256 sha256_of(const void *bytes, size_t size)
{
    struct sha256_ctx context;
    sha256_init(&context);
    sha256_update(&context, size, bytes);
    return finish(&context);
}

static ovr_status cannot(const ovr_input *input, int error, ovr_error *err)
{
    char text[128] = "";
    if (strerror_r(error, text, sizeof text) != 0)
        text[0] = '\0';
    return ovr_fail(err, OVR_BAD_INPUT, "%s: cannot be read: %s", input->path,
                    text);
}

/* Reads to the end of the file; stores the bytes up to the capacity. */
static ovr_status read_bytes(int fd, const ovr_input *input, size_t capacity,
                             content *to, ovr_error *err)
{
    struct sha256_ctx context;
    unsigned char block[CHUNK];
    ssize_t got;
    sha256_init(&context);
    to->size = 0;
    do {
        got = read(fd, block, sizeof block);
        if (got < 0 && errno != EINTR)
            return cannot(input, errno, err);
        if (got <= 0)
            continue;
        sha256_update(&context, (size_t)got, block);
        if (to->bytes && to->size + (size_t)got <= capacity)
            memcpy(to->bytes + to->size, block, (size_t)got);
        to->size += (size_t)got;
    } while (got != 0);
    to->sum = finish(&context);
    if (to->size > capacity)
        to->bytes = NULL;
    return OVR_OK;
}

/* Reads an input file. Pipes and devices are skipped, since the reader of the
 * case has consumed their bytes. */
static ovr_status load(const ovr_input *input, ovr_arena *arena, content *to,
                       ovr_error *err)
{
    struct stat about;
    ovr_status status;
    *to = (content){.ordinary = false};
    if (stat(input->path, &about) != 0)
        return cannot(input, errno, err);
    if (!S_ISREG(about.st_mode))
        return OVR_OK;
    int fd = open(input->path, O_RDONLY | O_CLOEXEC);
    if (fd < 0)
        return cannot(input, errno, err);
    to->ordinary = true;
    if (about.st_size <= OVR_INPUT_MAX) {
        to->bytes = ovr_arena_take(arena, (size_t)about.st_size, 1, err);
        if (!to->bytes) {
            close(fd);
            return OVR_NO_MEMORY;
        }
    }
    status = read_bytes(fd, input, (size_t)about.st_size, to, err);
    close(fd);
    return status;
}

/* ------------------------------------------------------------------ Writing */

static bool describe(hid_t set, const ovr_input *input, const content *from)
{
    return ovr_h5_set_string(set, "name", input->name) &&
           ovr_h5_set_string(set, "key", input->key) &&
           (!from->ordinary ||
            (ovr_h5_set_number(set, "bytes", (double)from->size) &&
             ovr_h5_set_string(set, "sha256", from->sum.text)));
}

static bool write_content(const ovr_file *f, hid_t group, const char *name,
                          const ovr_input *input, const content *from,
                          const ovr_scales *scales)
{
    size_t size = from->bytes ? (size_t)from->size : 0;
    hsize_t shape = size;
    ovr_new_dataset plan = {.name = name,
                            .long_name = "bytes of an input file",
                            .kind = OVR_KIND_NUMBER,
                            .type = H5T_STD_I8LE,
                            .rows = size && size < CHUNK ? size : CHUNK,
                            .rank = 1,
                            .deflate = f->deflate};
    hid_t set = ovr_header_dataset(group, &plan, scales);
    bool ok = set >= 0 && describe(set, input, from) &&
              (!size || (H5Dset_extent(set, &shape) >= 0 &&
                         H5Dwrite(set, H5T_NATIVE_SCHAR, H5S_ALL, H5S_ALL,
                                  H5P_DEFAULT, from->bytes) >= 0));
    ovr_h5_drop(set);
    return ok;
}

static ovr_status write_input(const ovr_file *f, const ovr_file_plan *plan,
                              hid_t group, const ovr_input *input, size_t *made,
                              ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(&f->store.changed.arena->allocator);
    content from;
    char name[32];
    ovr_status status = load(input, &arena, &from, err);
    snprintf(name, sizeof name, "file_%zu", ++*made);
    if (!status &&
        !(write_content(f, group, name, input, &from, plan->scales) &&
          ovr_h5_set_string(group, input->key, name)))
        status = ovr_fail(err, OVR_IO, "%s: the inputs cannot be written",
                          f->store.path);
    ovr_arena_release(&arena);
    return status;
}

/* Writes the name of the dataset of an earlier key with the same file. */
static bool write_again(hid_t group, const ovr_input *inputs, size_t k)
{
    size_t file = 1;
    char name[32];
    for (size_t i = 0; i < inputs[k].first; i++)
        file += inputs[i].first == i;
    snprintf(name, sizeof name, "file_%zu", file);
    return ovr_h5_set_string(group, inputs[k].key, name);
}

ovr_status ovr_inputs_write(const ovr_file *f, const ovr_file_plan *plan,
                            ovr_error *err)
{
    const ovr_write_options *o = plan->options;
    ovr_status status = OVR_OK;
    size_t made = 0;
    if (!o->input_count)
        return OVR_OK;
    hid_t group = ovr_header_group(f->file, "inputs", 0);
    for (size_t k = 0; group >= 0 && !status && k < o->input_count; k++)
        if (o->inputs[k].first == k)
            status = write_input(f, plan, group, &o->inputs[k], &made, err);
        else if (!write_again(group, o->inputs, k))
            status = OVR_IO;
    if (group < 0 || status == OVR_IO)
        status = ovr_fail(err, OVR_IO, "%s: the inputs cannot be written",
                          f->store.path);
    ovr_h5_drop(group);
    return status;
}

/* ---------------------------------------------------------------- Comparing */

static ovr_status differs(const ovr_input *input, ovr_error *err)
{
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: has changed since the run began (%s); 'overroll info "
                    "--inputs' writes the file as it was",
                    input->path, input->key);
}

/* Compares an input with the SHA-256 of its dataset, if there is one. */
static ovr_status check(ovr_container *c, uint64_t group,
                        const ovr_input *input, ovr_arena *arena,
                        ovr_error *err)
{
    const char *name = ovr_container_text(c, group, input->key);
    uint64_t object;
    if (!name || !ovr_container_find(c, group, name, &object))
        return OVR_OK;
    const char *sum = ovr_container_text(c, object, "sha256");
    content now;
    if (!sum)
        return OVR_OK;
    ovr_status status = load(input, arena, &now, err);
    if (!status && now.ordinary && strcmp(sum, now.sum.text) != 0)
        status = differs(input, err);
    return status;
}

ovr_status ovr_inputs_check(ovr_container *c, const ovr_write_options *o,
                            ovr_error *err)
{
    uint64_t group;
    ovr_status status = OVR_OK;
    if (!o->input_count || !ovr_container_find(c, c->root, "inputs", &group))
        return OVR_OK;
    for (size_t k = 0; !status && k < o->input_count; k++) {
        ovr_arena arena = ovr_arena_make(&c->source.arena->allocator);
        if (o->inputs[k].first == k)
            status = check(c, group, &o->inputs[k], &arena, err);
        ovr_arena_release(&arena);
    }
    return status;
}

/* ------------------------------------------------------------------ reading */

/* Reads the input files that a result file holds. */

enum { INPUTS_MAX = 4096, PART = 1 << 16 };

static const char *or_empty(const char *text)
{
    return text ? text : "";
}

/* Reads the attributes of an input's dataset; false for other objects. */
static bool describe_found(ovr_result *r, const ovr_link *link,
                           ovr_result_input *to)
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
    if (ovr_arena_status(&r->arena))
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < count; k++) {
        char path[80];
        snprintf(path, sizeof path, "inputs/%s", links[k].name);
        r->input_path[r->inputs] = ovr_arena_text(&r->arena, path, err);
        if (!r->input_path[r->inputs])
            return OVR_NO_MEMORY;
        r->inputs += describe_found(r, &links[k], &r->input[r->inputs]);
    }
    return OVR_OK;
}

const ovr_result_input *ovr_result_input_at(const ovr_result *r, size_t k)
{
    return r && k < r->inputs ? &r->input[k] : NULL;
}

/* ------------------------------------------------------------------ Reading */

/* Opens the file unless it is open; holds the lock until `leave`. */
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

static bool read_part(ovr_result *r, size_t k, unsigned char *bytes)
{
    size_t size = (size_t)r->input[k].bytes;
    ovr_dataset set;
    if (!ovr_reader_dataset(r, r->input_path[k], &set) || set.rank != 1 ||
        set.shape[0] != size)
        return false;
    double *values = ovr_arena_take(&r->work, PART, sizeof *values, NULL);
    for (size_t at = 0; values && at < size; at += PART) {
        size_t n = size - at < PART ? size - at : PART;
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
        return ovr_fail(err, OVR_BAD_INPUT, "%s: does not contain input %zu",
                        r->path, k + 1);
    const ovr_result_input *input = &r->input[k];
    int lock;
    bool ok = enter(r, &lock) && read_part(r, k, bytes);
    leave(r, lock);
    if (ok &&
        !strcmp(sha256_of(bytes, (size_t)input->bytes).text, input->sha256))
        return OVR_OK;
    return ovr_fail(err, OVR_IO,
                    ok ? "%s: its copy of '%.200s' does not have the SHA-256 "
                         "of that file: the result file is damaged"
                       : "%s: its copy of '%.200s' cannot be read: the result "
                         "file is damaged",
                    r->path, input->name);
}

/* Returns the index of a dataset in the list of inputs. */
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
