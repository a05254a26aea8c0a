/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "overroll/error.h"

#include <stdarg.h>
#include <stdio.h>

const char *ovr_status_name(ovr_status status)
{
    switch (status) {
    case OVR_OK: return "ok";
    case OVR_BAD_INPUT: return "bad input";
    case OVR_NOT_CONVERGED: return "not converged";
    case OVR_IMPOSSIBLE: return "impossible physics";
    case OVR_NO_MEMORY: return "out of memory";
    case OVR_IO: return "input/output error";
    case OVR_STOPPED: return "stopped";
    }
    return "unknown status";
}

/* Messages quote what stands in files: one line, and no word for the
 * terminal that shows it. */
static void one_line(char *text)
{
    for (; *text; text++)
        if ((unsigned char)*text < 0x20 || *text == 0x7f)
            *text = ' ';
}

ovr_status ovr_fail(ovr_error *err, ovr_status status, const char *format, ...)
{
    if (err) {
        va_list args;
        va_start(args, format);
        err->status = status;
        vsnprintf(err->message, sizeof err->message, format, args);
        va_end(args);
        one_line(err->message);
    }
    return status;
}

ovr_status ovr_fail_at(ovr_error *err, ovr_status status, const char *file,
                       long line, const char *format, ...)
{
    if (err) {
        va_list args;
        size_t used;
        err->status = status;
        if (line > 0)
            snprintf(err->message, sizeof err->message, "%s:%ld: ", file, line);
        else
            snprintf(err->message, sizeof err->message, "%s: ", file);
        for (used = 0; err->message[used];)
            used++;
        va_start(args, format);
        vsnprintf(err->message + used, sizeof err->message - used, format,
                  args);
        va_end(args);
        one_line(err->message);
    }
    return status;
}
