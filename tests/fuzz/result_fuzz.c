/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Result files: a file of any content is read or refused in one line, and
 * what its tables promise can be asked for.
 */
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "overroll/overroll.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* HDF5 leaks some of its own on damaged files. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libhdf5";
}

static char path[64];

static void forget(void)
{
    unlink(path);
}

static bool put(const uint8_t *data, size_t size)
{
    if (!path[0]) {
        snprintf(path, sizeof path, "/tmp/overroll-fuzz-%ld.h5",
                 (long)getpid());
        atexit(forget);
    }
    FILE *out = fopen(path, "wb");
    size_t written = out ? fwrite(data, 1, size, out) : 0;
    return out && fclose(out) == 0 && written == size;
}

/* Rows and nodes are as many as the file says they are, which may be more
 * than there is memory for. */
enum { MOST = 1 << 20 };

static void read_fields(ovr_result *r, const ovr_result_info *about)
{
    ovr_error err = {0};
    double *values = malloc((about->nodes + 1) * sizeof *values);
    for (size_t k = 0; values && k < ovr_result_fields(r); k++)
        if (about->snapshots)
            ovr_result_snapshot(r, ovr_result_field_name(r, k),
                                about->snapshots - 1, OVR_AS_STORED, values,
                                &err);
    if (values)
        ovr_result_x(r, OVR_HERTZIAN, values, &err);
    free(values);
}

static void read_history(ovr_result *r, const ovr_result_info *about)
{
    ovr_error err = {0};
    size_t rows = about->steps > about->snapshots ? about->steps
                                                  : about->snapshots;
    double *values = malloc((rows + 1) * sizeof *values);
    for (size_t k = 0; values && k < ovr_result_columns(r); k++)
        ovr_result_history(r, ovr_result_column(r, k)->name, OVR_SI, values,
                           &err);
    if (values)
        ovr_result_times(r, OVR_HERTZIAN, values, &err);
    free(values);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    ovr_error err = {0};
    ovr_result *r = put(data, size) ? ovr_result_open(path, NULL, &err) : NULL;
    if (!r && (!err.message[0] || strpbrk(err.message, "\n\r")))
        abort();
    if (!r)
        return 0;
    const ovr_result_info *about = ovr_result_about(r);
    if (about->nodes < MOST)
        read_fields(r, about);
    if (about->steps < MOST && about->snapshots < MOST)
        read_history(r, about);
    ovr_result_close(r);
    return 0;
}
