/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data of a page with its runs. */
#include <errno.h>
#include <libdeflate.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/given.h"
#include "base/text.h"
#include "case/case.h"
#include "pictures/chart.h"
#include "pictures/gnuplot.h"
#include "pictures/page.h"
#include "pictures/picture.h"
#include "pictures/view_data.h"
#include "run/run.h"

/* ------------------------------------------------------------ Packed levels */

static void text_base64(ovr_text *to, const void *data, size_t bytes)
{
    static const char digit[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *b = data;
    for (size_t i = 0; i < bytes; i += 3) {
        unsigned three = (unsigned)b[i] << 16 |
                         (i + 1 < bytes ? (unsigned)b[i + 1] << 8 : 0) |
                         (i + 2 < bytes ? (unsigned)b[i + 2] : 0);
        char four[4] = {digit[three >> 18], digit[three >> 12 & 63],
                        i + 1 < bytes ? digit[three >> 6 & 63] : '=',
                        i + 2 < bytes ? digit[three & 63] : '='};
        ovr_text_add(to, four, 4);
    }
}

ovr_levels ovr_levels_even(double low, double high)
{
    double span = high > low ? high - low : 1;
    return (ovr_levels){low, span / (OVR_PACKED_LEVELS - 1), 0};
}

/* Returns levels with a small relative error for values above about `small`. */
static ovr_levels levels_bent(double small, double high)
{
    double bend = small > 0 ? small : 1;
    return (ovr_levels){
        0, asinh(fmax(high / bend, 1)) / (OVR_PACKED_LEVELS - 1), bend};
}

uint16_t ovr_level_of(const ovr_levels *l, double value)
{
    double at = l->bend != 0 ? asinh(value / l->bend) / l->step
                             : (value - l->from) / l->step;
    return (uint16_t)(at > 0 ? fmin(at + 0.5, OVR_PACKED_LEVELS - 1) : 0);
}

/* Replaces levels by prediction errors, from the end, so that neighbours are
 * still unchanged. */
static void replace_by_differences(uint16_t *level, size_t n, size_t rows)
{
    for (size_t i = n * rows; i-- > 0;) {
        unsigned left = i % n ? level[i - 1] : 0;
        unsigned before = i >= n ? level[i - n] : 0;
        unsigned both = i % n && i >= n ? level[i - n - 1] : 0;
        int d = (int)level[i] - (int)(left + before) + (int)both;
        level[i] = (uint16_t)((unsigned)(d < 0 ? -2 * d - 1 : 2 * d));
    }
}

ovr_status ovr_pack_levels(ovr_text *to, uint16_t *level, size_t n, size_t rows,
                           ovr_arena *arena, ovr_error *err)
{
    enum { LEVEL = 6 };
    size_t count = n * rows;
    struct libdeflate_compressor *deflate = libdeflate_alloc_compressor(LEVEL);
    size_t bound = libdeflate_zlib_compress_bound(deflate, 2 * count);
    unsigned char *planes = ovr_arena_take(arena, 2 * count, 1, err);
    unsigned char *small = ovr_arena_take(arena, bound, 1, err);
    if (!deflate)
        return ovr_fail(err, OVR_NO_MEMORY, "out of memory (compression)");
    if (!planes || !small) {
        libdeflate_free_compressor(deflate);
        return OVR_NO_MEMORY;
    }
    replace_by_differences(level, n, rows);
    for (size_t i = 0; i < count; i++) {
        planes[i] = (unsigned char)(level[i] & 0xff);
        planes[count + i] = (unsigned char)(level[i] >> 8);
    }
    size_t packed = libdeflate_zlib_compress(deflate, planes, 2 * count, small,
                                             bound);
    libdeflate_free_compressor(deflate);
    text_base64(to, small, packed);
    return ovr_text_status(to, err);
}

void ovr_text_doubles(ovr_text *to, const char *key, const double *values,
                      size_t n)
{
    ovr_text_print(to, "\"%s\":\"", key);
    text_base64(to, values, n * sizeof *values);
    ovr_text_put(to, "\",");
}

/* --------------------------------------------------------- Data of the page */

/* Limits of a page. Above them nodes and snapshots are omitted uniformly. */
enum { MAX_NODES = 4000, MAX_STEPS = 4000, MAX_VALUES = 4000000 };

/* --------------------------------------------------------------- escaping */

static void append_json(ovr_text *to, const char *character, int bytes)
{
    if (bytes == 1 && strchr("<>&\"'\\", *character))
        ovr_text_print(to, "\\u%04x", (unsigned)*character);
    else
        ovr_text_add(to, character, (size_t)bytes);
}

static void append_string(ovr_text *to, const char *key, const char *foreign)
{
    ovr_text_print(to, "\"%s\":\"", key);
    ovr_text_foreign(to, foreign, append_json);
    ovr_text_put(to, "\",");
}

/* ----------------------------------------------------------------- fields */

/* Smallest positive, minimum and maximum of the stored values. */
typedef struct span {
    double positive, low, high;
} span;

/* Distribution of the levels of a field. */
typedef enum lie { FROM_ZERO, BENT, FROM_LOWEST } lie;

typedef struct field {
    const char *key, *name;
    lie lie;
} field;

static ovr_status read_row(const ovr_view_run *w, const char *name, size_t row,
                           double *values, ovr_error *err)
{
    ovr_status status = ovr_result_snapshot(
        w->run->result, name, row * w->every, OVR_HERTZIAN, values, err);
    for (size_t i = 0; status == OVR_OK && i < w->nodes; i++)
        values[i] = values[i * w->stride];
    return status;
}

static ovr_status find_span(const ovr_view_run *w, const char *name,
                            double *values, span *s, ovr_error *err)
{
    *s = (span){INFINITY, INFINITY, -INFINITY};
    for (size_t k = 0; k < w->snapshots; k++) {
        ovr_status status = read_row(w, name, k, values, err);
        if (status != OVR_OK)
            return status;
        for (size_t i = 0; i < w->nodes; i++) {
            s->low = fmin(s->low, values[i]);
            s->high = fmax(s->high, values[i]);
            if (values[i] > 0)
                s->positive = fmin(s->positive, values[i]);
        }
    }
    return OVR_OK;
}

static ovr_status append_levels(ovr_view_run *w, const field *f,
                                const ovr_levels *l, double *values,
                                ovr_error *err)
{
    uint16_t *level = ovr_arena_take(w->arena, w->nodes * w->snapshots,
                                     sizeof *level, err);
    ovr_status status = level ? OVR_OK : OVR_NO_MEMORY;
    for (size_t k = 0; status == OVR_OK && k < w->snapshots; k++) {
        status = read_row(w, f->name, k, values, err);
        for (size_t i = 0; status == OVR_OK && i < w->nodes; i++)
            level[k * w->nodes + i] = ovr_level_of(l, values[i]);
    }
    if (status != OVR_OK)
        return status;
    ovr_text_print(w->to,
                   "\"%s\":{\"levels\":%d,\"from\":%.17g,\"step\":%.17g,"
                   "\"bend\":%.17g,\"data\":\"",
                   f->key, OVR_PACKED_LEVELS, l->from, l->step, l->bend);
    status = ovr_pack_levels(w->to, level, w->nodes, w->snapshots, w->arena,
                             err);
    ovr_text_put(w->to, "\"},");
    return status;
}

static ovr_status append_field(ovr_view_run *w, const field *f, ovr_error *err)
{
    double *values = ovr_arena_take(w->arena, w->run->info->nodes,
                                    sizeof *values, err);
    ovr_levels levels;
    ovr_status status;
    span s;
    if (!values)
        return OVR_NO_MEMORY;
    status = find_span(w, f->name, values, &s, err);
    if (status != OVR_OK)
        return status;
    if (f->lie == BENT)
        levels = levels_bent(0.5 * s.positive, s.high);
    else
        levels = ovr_levels_even(f->lie == FROM_ZERO ? fmin(s.low, 0) : s.low,
                                 s.high);
    return append_levels(w, f, &levels, values, err);
}

static ovr_status append_fields(ovr_view_run *w, ovr_error *err)
{
    static const field fields[] = {
        {"P", "pressure", FROM_ZERO},
        {"H", "film_thickness", BENT},
        {"S", "roughness", FROM_ZERO},
        {"F", "filling", FROM_ZERO},
        {"T1", "temperature_1", FROM_LOWEST},
        {"T2", "temperature_2", FROM_LOWEST},
        {"T3", "temperature_middle", FROM_LOWEST},
        {"C", "contact_pressure", FROM_ZERO},
    };
    const ovr_stored *run = w->run;
    const bool there[] = {run->pressure, run->film,   run->roughness,
                          run->filling,  run->hot[0], run->hot[1],
                          run->hot[2],   run->touches};
    ovr_status status = OVR_OK;
    for (size_t k = 0; !status && k < sizeof fields / sizeof *fields; k++)
        if (there[k])
            status = append_field(w, &fields[k], err);
    return status;
}

/* ---------------------------------------------------------------- history */

/* Reduces each bucket of steps to one value: the first, the minimum or the
 * maximum. */
static size_t reduce(double *values, size_t n, size_t bucket, char keep)
{
    size_t count = 0;
    for (size_t i = 0; i < n; i += bucket) {
        double value = values[i];
        for (size_t j = i; j < n && j < i + bucket; j++)
            if ((keep == '<' && values[j] < value) ||
                (keep == '>' && values[j] > value))
                value = values[j];
        values[count++] = value;
    }
    return count;
}

/* Writes half-width and pressure of the Hertzian contact for each snapshot. */
static void append_hertz(ovr_view_run *w)
{
    double *two = ovr_arena_take(w->arena, 2 * w->snapshots, sizeof *two, NULL);
    if (!w->run->hertz_P || !two)
        return;
    for (size_t k = 0; k < w->snapshots; k++) {
        two[2 * k] = w->run->hertz_width[k * w->every];
        two[2 * k + 1] = w->run->hertz_P[k * w->every];
    }
    ovr_text_doubles(w->to, "hertz", two, 2 * w->snapshots);
}

static ovr_status append_history(ovr_view_run *w, ovr_error *err)
{
    static const struct {
        const char *key, *name;
        char keep;
    } columns[] = {{"time", "time", '.'},
                   {"H_min", "min_film_thickness", '<'},
                   {"H_cen", "central_film_thickness", '.'},
                   {"P_max", "max_pressure", '>'}};
    size_t n = w->run->info->steps, bucket = n / MAX_STEPS + 1;
    ovr_text_put(w->to, "\"history\":{");
    for (int k = 0; n > 0 && k < 4; k++) {
        double *v = ovr_stored_history(w->run, columns[k].name, 1, w->arena,
                                       err);
        if (!v)
            return err->status;
        ovr_text_doubles(w->to, columns[k].key, v,
                         reduce(v, n, bucket, columns[k].keep));
    }
    ovr_text_put(w->to, "\"steps\":0},");
    return OVR_OK;
}

/* ------------------------------------------------------------------ units */

static ovr_status append_axes(ovr_view_run *w, ovr_units units, ovr_error *err)
{
    const ovr_stored *run = w->run;
    const struct {
        char key;
        ovr_unit_kind kind;
        double largest;
    } axes[] = {{'x', OVR_KIND_LENGTH, 1.5},
                {'p', OVR_KIND_PRESSURE, 1},
                {'h', OVR_KIND_HEIGHT, 0.1},
                {'t', OVR_KIND_TIME, run->times[run->info->snapshots - 1]}};
    ovr_text_put(w->to, "{");
    for (int k = 0; k < 4; k++) {
        ovr_axis a;
        ovr_status status = ovr_axis_make(axes[k].kind, run->result, units,
                                          axes[k].largest, &a, err);
        if (status != OVR_OK)
            return status;
        ovr_text_print(w->to, "\"%c\":{\"f\":%.17g,", axes[k].key, a.factor);
        append_string(w->to, "unit", a.unit);
        append_string(w->to, "name", a.plain);
        ovr_text_put(w->to, "\"kind\":0},");
    }
    ovr_text_put(w->to, "\"end\":0}");
    return OVR_OK;
}

static ovr_status append_units(ovr_view_run *w, ovr_error *err)
{
    const ovr_result_info *i = w->run->info;
    bool scales = i->b > 0 && i->ph > 0 && i->height > 0 && i->time > 0;
    ovr_status status;
    ovr_text_put(w->to, "\"units\":[");
    status = append_axes(w, OVR_HERTZIAN, err);
    if (status == OVR_OK && scales) {
        ovr_text_put(w->to, ",");
        status = append_axes(w, OVR_SI, err);
    }
    ovr_text_put(w->to, "]}");
    return status;
}

/* ------------------------------------------------------------------- runs */

static void append_about(ovr_view_run *w)
{
    const ovr_result_info *i = w->run->info;
    ovr_text_print(w->to, "\"about\":\"M = %.4g, L = %.4g", i->M, i->L);
    if (i->ph > 0)
        ovr_text_print(w->to, ", p_h = %.3g GPa", i->ph * 1e-9);
    if (w->run->unresolved)
        ovr_text_print(w->to, ", maximum pressure not resolved (%s)",
                       w->run->unresolved);
    if (w->run->flagged)
        ovr_text_print(w->to, ", %zu flagged step%s (not converged)",
                       w->run->flagged, w->run->flagged > 1 ? "s" : "");
    ovr_text_put(w->to, "\",");
}

static void choose(ovr_view_run *w)
{
    const ovr_result_info *i = w->run->info;
    w->stride = (i->nodes - 1) / MAX_NODES + 1;
    w->nodes = (i->nodes - 1) / w->stride + 1;
    w->every = w->nodes * i->snapshots / MAX_VALUES + 1;
    w->snapshots = (i->snapshots - 1) / w->every + 1;
}

static void append_answer(void *view, const char *name, const char *text)
{
    ovr_view_run *w = view;
    ovr_text_put(w->to, "{");
    append_string(w->to, "name", name);
    append_string(w->to, "text", text);
    ovr_text_put(w->to, "\"kind\":0},");
}

/* Writes the numbers of a gear pair, cam or bearing. */
static void append_answers(ovr_view_run *w)
{
    ovr_text_put(w->to, "\"answers\":[");
    ovr_result_answers(w->run->result, append_answer, w);
    ovr_text_put(w->to, "0],");
}

static ovr_status append_run(ovr_view_run *w, ovr_error *err)
{
    double *x, *times;
    ovr_status status;
    choose(w);
    x = ovr_arena_take(w->arena, w->nodes, sizeof *x, err);
    times = ovr_arena_take(w->arena, w->snapshots, sizeof *times, err);
    if (ovr_arena_status(w->arena))
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < w->nodes; i++)
        x[i] = w->run->x[i * w->stride];
    for (size_t k = 0; k < w->snapshots; k++)
        times[k] = w->run->times[k * w->every];
    ovr_text_put(w->to, "{");
    append_string(w->to, "name", w->run->name);
    append_about(w);
    append_answers(w);
    ovr_view_element(w);
    ovr_text_print(w->to, "\"nodes\":%zu,\"snapshots\":%zu,", w->nodes,
                   w->snapshots);
    ovr_text_doubles(w->to, "x", x, w->nodes);
    ovr_text_doubles(w->to, "time", times, w->snapshots);
    append_hertz(w);
    status = append_fields(w, err);
    if (status == OVR_OK)
        status = ovr_view_areal(w, err);
    if (status == OVR_OK)
        status = ovr_view_stress(w, err);
    if (status == OVR_OK)
        status = ovr_view_material(w, err);
    if (status == OVR_OK)
        status = append_history(w, err);
    if (status == OVR_OK)
        status = append_units(w, err);
    return status;
}

/* Writes the data of the page, with the chosen stress field, or none if
 * `stress` is NULL. */
static ovr_status view_data(ovr_text *to, const ovr_stored *runs, size_t count,
                            const char *stress, ovr_arena *arena,
                            ovr_error *err)
{
    ovr_view_run w = {
        .to = to, .arena = arena, .stress = stress, .stride = 1, .every = 1};
    ovr_status status = OVR_OK;
    ovr_text_put(to, "{\"runs\":[");
    for (size_t k = 0; status == OVR_OK && k < count; k++) {
        if (k > 0)
            ovr_text_put(to, ",");
        w.run = &runs[k];
        status = append_run(&w, err);
    }
    ovr_text_print(to,
                   "],\"precision\":\"Values in this page are rounded: "
                   "pressure, roughness and temperatures to 1/%d of their "
                   "range, film thickness to 0.02 %%. The result file has them "
                   "all",
                   2 * OVR_PACKED_LEVELS);
    if (w.stride > 1 || w.every > 1)
        ovr_text_print(to,
                       "; this page contains every %zuth node and every "
                       "%zuth snapshot",
                       w.stride, w.every);
    ovr_text_put(to, ".\"}");
    return status;
}

/* --------------------------------------------------------------------- page */

/* The page: page.html with the data of the runs as JSON. Everything from a file
 * is escaped when written, so that it cannot close an element. */

static void append_html(ovr_text *to, const char *character, int bytes)
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
            ovr_text_foreign(page, title, append_html);
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

/* Returns the title; for two results with different titles both. */
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
        status = view_data(&data, runs, count, o->stress, arena, err);
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
