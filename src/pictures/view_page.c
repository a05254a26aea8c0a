/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The page: page.html with the runs' data in it as JSON.  Everything from a
 * file is escaped where it is written: nothing in it can end an element.
 */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/given.h"
#include "base/plain.h"
#include "pictures/gnuplot.h"
#include "pictures/page.h"
#include "pictures/picture.h"
#include "pictures/view_data.h"
#include "run/run.h"

static void put_html(ovr_text *to, const char *character, int bytes)
{
    switch (*character) {
    case '<': ovr_text_put(to, "&lt;"); break;
    case '>': ovr_text_put(to, "&gt;"); break;
    case '&': ovr_text_put(to, "&amp;"); break;
    case '"': ovr_text_put(to, "&quot;"); break;
    default: ovr_text_add(to, character, (size_t)bytes);
    }
}

static const char *find(const char *text, const char *end, const char *what)
{
    size_t length = strlen(what);
    for (; text + length <= end; text++)
        if (memcmp(text, what, length) == 0)
            return text;
    return end;
}

static ovr_status write_page(ovr_text *page, const char *title,
                             const ovr_text *data, ovr_error *err)
{
    const char *at = ovr_page_text, *end = at + ovr_page_bytes;
    while (at < end) {
        const char *name = find(at, end, "@TITLE@");
        const char *here = find(at, name, "@DATA@");
        ovr_text_add(page, at, (size_t)(here - at));
        at = here;
        if (here < name) {
            ovr_text_add(page, data->data, data->length);
            at += strlen("@DATA@");
        } else if (name < end) {
            ovr_text_foreign(page, title, put_html);
            at += strlen("@TITLE@");
        }
    }
    return ovr_text_status(page, err);
}

static ovr_status save(const ovr_text *page, const char *path, ovr_error *err)
{
    char part[OVR_PATH_SIZE];
    ovr_status status = ovr_part_make(part, path, err);
    if (status != OVR_OK)
        return status;
    status = ovr_text_save_anew(page, part, err);
    if (status == OVR_OK && rename(part, path) != 0)
        status = ovr_fail(err, OVR_IO, "%s: cannot be written: %s", path,
                          strerror(errno));
    if (status != OVR_OK)
        unlink(part);
    return status;
}

/* The two of a comparison, where they differ. */
static const char *title_of(const ovr_stored *runs, size_t count,
                            const char *given, ovr_arena *arena)
{
    const char *title = ovr_stored_title(runs, count, given);
    char two[400];
    if (*title || given || count < 2)
        return title;
    snprintf(two, sizeof two, "%.180s and %.180s", runs[0].info->title,
             runs[1].info->title);
    title = ovr_arena_text(arena, two, NULL);
    return title ? title : "";
}

static ovr_status view(ovr_result *const *results, size_t count,
                       const ovr_view_options *o, ovr_arena *arena,
                       ovr_error *err)
{
    ovr_stored *runs = ovr_arena_take(arena, count, sizeof *runs, err);
    ovr_text data = ovr_text_make(arena), page = ovr_text_make(arena);
    ovr_status status = runs ? ovr_may_create(o->path, o->force, err)
                             : OVR_NO_MEMORY;
    for (size_t k = 0; status == OVR_OK && k < count; k++)
        status = ovr_stored_make(&runs[k], results[k],
                                 o->names ? o->names[k] : NULL, arena, err);
    for (size_t k = 0; status == OVR_OK && k < count; k++)
        status = ovr_stored_need_snapshots(&runs[k], err);
    if (status == OVR_OK)
        status = ovr_view_data(&data, runs, count, o->stress, arena, err);
    if (status == OVR_OK)
        status = ovr_text_status(&data, err);
    if (status == OVR_OK)
        status = write_page(&page, title_of(runs, count, o->title, arena),
                            &data, err);
    if (status == OVR_OK)
        status = save(&page, o->path, err);
    return status;
}

ovr_status ovr_view(ovr_result *const *results, size_t count,
                    const ovr_view_options *given,
                    const ovr_allocator *allocator, ovr_error *err)
{
    ovr_view_options own, *options = &own;
    if (OVR_TAKE(ovr_view_options, options, given, err))
        return OVR_BAD_INPUT;
    if (!results)
        return ovr_fail_null(err, __func__);
    locale_t before = ovr_plain_begin();
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_error unasked;
    ovr_status status = view(results, count, options, &arena,
                             err ? err : &unasked);
    ovr_arena_release(&arena);
    ovr_plain_end(before);
    return status;
}
