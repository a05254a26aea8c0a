/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forwards messages of a run and stores its warnings. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "run/internal.h"
#include "run/review.h"

/* Doubles the capacity for warnings if it is used up. Returns false if memory
 * is insufficient; the warning is then only printed. */
static bool has_space(ovr_run *run)
{
    size_t count = (size_t)run->info.warnings;
    const char **more;
    if (count < run->warnings_capacity)
        return true;
    more = ovr_arena_take(&run->arena, 2 * count + 8, sizeof *more, NULL);
    for (size_t k = 0; more && k < count; k++)
        more[k] = run->warning[k];
    if (!more)
        return false;
    run->warning = more;
    run->warnings_capacity = 2 * count + 8;
    run->info.warning = more;
    return true;
}

static void keep(ovr_run *run, const char *text)
{
    char *copy = has_space(run) ? ovr_arena_text(&run->arena, text, NULL)
                                : NULL;
    if (copy)
        run->warning[run->info.warnings++] = copy;
}

/* True if another of several passes has issued the same warning. */
static bool was_issued(const ovr_run *run, const char *text)
{
    for (int k = 0; run->passes && k < run->info.warnings; k++)
        if (strcmp(run->warning[k], text) == 0)
            return true;
    return false;
}

void ovr_run_message(void *data, ovr_message_kind kind, const char *text)
{
    ovr_run *run = data;
    if (kind == OVR_MESSAGE_WARNING && was_issued(run, text))
        return;
    if (kind == OVR_MESSAGE_WARNING)
        keep(run, text);
    if (run->how.say)
        run->how.say(run->how.data, kind, text);
}

void ovr_run_recall(ovr_run *run, const char *warnings)
{
    char line[OVR_MESSAGE_SIZE];
    while (*warnings) {
        size_t length = strcspn(warnings, "\n");
        snprintf(line, sizeof line, "%.*s", (int)length, warnings);
        if (!was_issued(run, line))
            keep(run, line);
        warnings += length + (warnings[length] == '\n');
    }
}

void ovr_run_warn(ovr_run *run, const char *format, ...)
{
    char text[OVR_MESSAGE_SIZE];
    size_t used = 0;
    va_list args;
    if (run->passes)
        used = (size_t)snprintf(text, sizeof text, "pass %d: ", run->info.pass);
    va_start(args, format);
    vsnprintf(text + used, sizeof text - used, format, args);
    va_end(args);
    ovr_run_message(run, OVR_MESSAGE_WARNING, text);
}

void ovr_review_add(const ovr_review *r, ovr_message_kind kind,
                    const char *format, ...)
{
    char text[OVR_MESSAGE_SIZE];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    if (r->say)
        r->say(r->data, kind, text);
}
