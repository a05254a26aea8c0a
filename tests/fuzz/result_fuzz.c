/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: result files. A file with any content is read or rejected with a
 * message of one line, and all entries of its tables can be read. No count
 * exceeds the file size, so that the memory allocated by a caller is bounded.
 * The reader built for fuzzing accepts any checksum, so that the code after the
 * checksum is reached. */
#define _GNU_SOURCE /* memfd_create */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "overroll/overroll.h"
#include "results/reader.h"
#include "results/results.h"

/* Reads all datasets of any rank in all groups; each must report a bounded
 * size. */
static void read_all(ovr_result *r)
{
    enum { MAX = 1 << 20 };
    ovr_error err = {0};
    double *values = malloc(MAX * sizeof *values);
    for (size_t k = 0; values && k < r->variables; k++) {
        const ovr_variable *v = &r->variable[k];
        size_t count = v->rank == 1 ? v->shape[0] : 1;
        for (int d = 1; d < v->rank; d++)
            count *= v->shape[d];
        if (count <= MAX)
            ovr_result_read(r, v->path, 0, OVR_AS_STORED, values, &err);
    }
    free(values);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static char path[64];

/* A file in memory: one on a disk takes longer than what is tested. */
static bool put(const uint8_t *data, size_t size)
{
    static int file = -1;
    if (file < 0) {
        file = memfd_create("overroll-fuzz", MFD_CLOEXEC);
        snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    }
    return file >= 0 && ftruncate(file, 0) == 0 &&
           pwrite(file, data, size, 0) == (ssize_t)size;
}

static void read_fields(ovr_result *r, const ovr_result_info *about)
{
    ovr_error err = {0};
    double *values = malloc((about->nodes + 1) * sizeof *values);
    for (size_t k = 0; values && k < ovr_result_fields(r); k++)
        if (about->snapshots)
            ovr_result_snapshot(r, ovr_result_field(r, k)->name,
                                about->snapshots - 1, OVR_AS_STORED, values,
                                &err);
    if (values)
        ovr_result_x(r, OVR_HERTZIAN, values, &err);
    free(values);
}

static void read_inputs(ovr_result *r)
{
    ovr_error err = {0};
    const ovr_result_input *input;
    for (size_t k = 0; (input = ovr_result_input_at(r, k)); k++) {
        unsigned char *bytes = input->kept ? malloc((size_t)input->bytes + 1)
                                           : NULL;
        if (bytes)
            ovr_result_input_read(r, k, bytes, &err);
        free(bytes);
    }
    ovr_result_input_of(r, "feature scratch.file");
}

static void read_history(ovr_result *r, const ovr_result_info *about)
{
    ovr_error err = {0};
    size_t rows = about->steps > about->snapshots ? about->steps
                                                  : about->snapshots;
    double *values = malloc((rows + 1) * sizeof *values);
    for (size_t k = 0; values && ovr_result_column(r, k); k++)
        ovr_result_history(r, ovr_result_column(r, k)->name, OVR_SI, values,
                           &err);
    if (values)
        ovr_result_times(r, OVR_HERTZIAN, values, &err);
    free(values);
}

/* The rows of several passes, or of a study. */
static void read_table(size_t size)
{
    ovr_error err = {0};
    ovr_table *table = ovr_table_read(path, &err);
    if (!table && (!err.message[0] || strpbrk(err.message, "\n\r")))
        abort();
    if (table && ovr_table_rows(table) > size)
        abort();
    ovr_table_free(table);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    ovr_error err = {0};
    if (size > 4 && !memcmp(data + 1, "HDF", 3) && put(data, size))
        read_table(size);
    ovr_result *r = put(data, size) ? ovr_result_open(path, NULL, &err) : NULL;
    if (!r && (!err.message[0] || strpbrk(err.message, "\n\r")))
        abort();
    if (!r)
        return 0;
    const ovr_result_info *about = ovr_result_get_info(r);
    if (about->nodes > size || about->snapshots > size || about->steps > size)
        abort();
    read_fields(r, about);
    read_history(r, about);
    read_inputs(r);
    read_all(r);
    ovr_result_close(r);
    return 0;
}
