/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "base/text.h"

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

/* Messages quote the contents of files: line ends and tabs become blanks, other
 * control characters are escaped (\x1b).  Those of a name are all escaped. */
static void escape(char message[OVR_MESSAGE_SIZE], bool is_name)
{
    char given[OVR_MESSAGE_SIZE];
    const char *s = given;
    char *to = message, *stop = message + OVR_MESSAGE_SIZE;
    memcpy(given, message, strlen(message) + 1);
    while (*s) {
        int control = ovr_control_bytes(s, false);
        if (stop - to <= (control ? 4 * control : 1))
            break;
        if (!control)
            *to++ = *s++;
        else if (!is_name && !ovr_control_bytes(s, true)) {
            *to++ = ' ';
            s++;
        } else
            for (; control > 0; control--)
                to += snprintf(to, 5, "\\x%02x", (unsigned)(unsigned char)*s++);
    }
    *to = '\0';
}

static void write_message(ovr_error *err, ovr_status status, const char *about,
                          const char *file, long line, const char *format,
                          va_list args)
{
    char *end = err->message, *stop = end + sizeof err->message;
    err->status = status;
    err->about = about;
    err->meant = NULL;
    err->line = file && line > 0 ? line : 0;
    *end = '\0';
    if (file)
        snprintf(end, sizeof err->message, "%s", file);
    escape(err->message, true);
    err->file = strlen(end);
    end += err->file;
    if (err->line)
        snprintf(end, (size_t)(stop - end), ":%ld: ", line);
    else if (file)
        snprintf(end, (size_t)(stop - end), ": ");
    end += strlen(end);
    if (format)
        vsnprintf(end, (size_t)(stop - end), format, args);
    escape(err->message, false);
}

ovr_status ovr_fail(ovr_error *err, ovr_status status, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    if (err)
        write_message(err, status, NULL, NULL, 0, format, args);
    va_end(args);
    return status;
}

ovr_status ovr_fail_at(ovr_error *err, ovr_status status, const char *file,
                       long line, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    if (err)
        write_message(err, status, NULL, file, line, format, args);
    va_end(args);
    return status;
}

ovr_status ovr_fail_about(ovr_error *err, const char *about, const char *format,
                          ...)
{
    va_list args;
    va_start(args, format);
    if (err)
        write_message(err, OVR_BAD_INPUT, about, NULL, 0, format, args);
    va_end(args);
    return OVR_BAD_INPUT;
}

ovr_status ovr_fail_meant(ovr_error *err, ovr_status status, const char *meant)
{
    if (err)
        err->meant = meant;
    return status;
}

/* Returns the message without its leading key, if the error was caused by an
 * option with the same name as that key ("--L"). */
static const char *message_without_key(const char *file, const ovr_error *why)
{
    size_t key = why->about ? strlen(why->about) : 0;
    bool same = key && !strncmp(file, "--", 2) && !strcmp(file + 2, why->about);
    return same && !strncmp(why->message, why->about, key) &&
                   !strncmp(why->message + key, ": ", 2)
               ? why->message + key + 2
               : why->message;
}

ovr_status ovr_fail_from(ovr_error *err, const ovr_error *why, const char *file,
                         long line)
{
    if (!why)
        return ovr_fail_null(err, __func__);
    ovr_error copy = *why;
    ovr_status status = copy.status;
    if (!err)
        return status;
    if (!file) {
        *err = copy;
        return status;
    }
    ovr_fail_at(err, status, file, line, "%s",
                message_without_key(file, &copy));
    err->about = copy.about;
    err->meant = copy.meant;
    return status;
}

ovr_status ovr_fail_null(ovr_error *err, const char *function)
{
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: an argument is NULL, which is not allowed", function);
}

void *ovr_null(ovr_error *err, const char *function)
{
    ovr_fail_null(err, function);
    return NULL;
}

/* ---------------------------------------------------------------- Arguments */

ovr_status ovr_given(void *to, size_t size, const void *from, const char *name,
                     ovr_error *err)
{
    if (!from)
        return ovr_fail(err, OVR_BAD_INPUT, "no %s is given", name);
    memcpy(to, from, size);
    return OVR_OK;
}

ovr_status ovr_check_output_argument(const void *to, const char *name,
                                     ovr_error *err)
{
    return to ? OVR_OK
              : ovr_fail(err, OVR_BAD_INPUT, "no %s to fill is given", name);
}
