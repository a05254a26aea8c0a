/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pictures of all snapshots. A first pass over the snapshots finds the ranges
 * of the axes, a second one draws. This thread reads data and writes scripts;
 * one gnuplot process per core draws and receives its next frame when its last
 * one is complete. Frames are therefore completed in order and can be added to
 * a movie at once.
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "base/given.h"
#include "base/text.h"
#include "physics/stress/pictures_depth.h"
#include "pictures/areal.h"
#include "pictures/gnuplot.h"
#include "pictures/picture.h"
#include "pictures/snapshot.h"

typedef struct movie_file {
    ovr_process process;
    const char *path;
    char made[OVR_PATH_SIZE];
} movie_file;

/* -------------------------------------------------------------------- Movie */

/* ffmpeg reads the pictures from its standard input, so that none must be
 * stored on disk. Sizes are made even, as codecs require. */

#define EVEN "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,format=yuv420p"

enum { CODEC_WORDS = 12 };

static const struct form {
    const char *suffix, *muxer;
    const char *codec[CODEC_WORDS];
} forms[] = {
    {".mp4",
     "mp4",
     {"-vf", EVEN, "-c:v", "libx264", "-preset", "veryfast", "-crf", "18",
      "-movflags", "+faststart"}},
    {".webm",
     "webm",
     {"-vf", EVEN, "-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0", "-row-mt",
      "1"}},
    {".gif",
     "gif",
     {"-filter_complex", "split[a][b];[a]palettegen=max_colors=64[p];"
                         "[b][p]paletteuse=dither=none:diff_mode=rectangle"}},
    {".webp", "webp", {"-c:v", "libwebp", "-loop", "0", "-q:v", "75"}},
};

static const struct form *form_of(const char *path)
{
    size_t length = strlen(path);
    for (size_t k = 0; k < sizeof forms / sizeof *forms; k++) {
        size_t end = strlen(forms[k].suffix);
        if (length > end &&
            strcasecmp(path + length - end, forms[k].suffix) == 0)
            return &forms[k];
    }
    return NULL;
}

static ovr_status start(movie_file *m, const struct form *form, double rate,
                        ovr_error *err)
{
    char rate_text[40], output[OVR_PATH_SIZE + 8];
    const char *argv[32] = {"ffmpeg", "-nostdin", "-hide_banner", "-loglevel",
                            "error",  "-y",       "-f",           "image2pipe",
                            "-c:v",   "png",      "-framerate",   rate_text,
                            "-i",     "pipe:0"};
    size_t n = 14;
    snprintf(rate_text, sizeof rate_text, "%.6g", rate);
    /* The prefix "file:" prevents ffmpeg from interpreting a name as a protocol
     * or option. */
    snprintf(output, sizeof output, "file:%s", m->made);
    for (int k = 0; k < CODEC_WORDS && form->codec[k]; k++)
        argv[n++] = form->codec[k];
    argv[n++] = "-f";
    argv[n++] = form->muxer;
    argv[n++] = output;
    argv[n] = NULL;
    return ovr_process_start(&m->process, argv, "ffmpeg", err);
}

/* Starts a movie; the suffix of `path` selects the format. */
static ovr_status movie_start(movie_file *m, const char *path, double rate,
                              ovr_error *err)
{
    const struct form *form = form_of(path);
    ovr_status status;
    memset(m, 0, sizeof *m);
    if (!form)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: the name of a movie must end in .mp4, .webm, "
                        ".gif or .webp",
                        path);
    status = ovr_part_make(m->made, path, err);
    if (status == OVR_OK)
        status = start(m, form, rate, err);
    if (status == OVR_OK)
        m->path = path;
    else if (m->made[0])
        unlink(m->made);
    return status;
}

static ovr_status failed(movie_file *m, ovr_error *err)
{
    char why[400];
    ovr_process_end(&m->process, why, sizeof why);
    unlink(m->made);
    ovr_fail(err, OVR_IO, "%.400s: ffmpeg: %s", m->path,
             why[0] ? why : "no movie was made");
    m->path = NULL;
    return OVR_IO;
}

/* Adds a PNG file. */
static ovr_status movie_add(movie_file *m, const char *picture, ovr_error *err)
{
    char data[16384];
    FILE *file = fopen(picture, "rb");
    size_t got = 1;
    bool heard = true;
    if (!file)
        return ovr_fail(err, OVR_IO, "%s: %s", picture, strerror(errno));
    while (heard && (got = fread(data, 1, sizeof data, file)) > 0)
        heard = ovr_process_send(&m->process, data, got);
    fclose(file);
    return heard ? OVR_OK : failed(m, err);
}

/* Completes the movie and renames it to its final name. */
static ovr_status movie_finish(movie_file *m, ovr_error *err)
{
    char why[400];
    if (!ovr_process_end(&m->process, why, sizeof why)) {
        unlink(m->made);
        ovr_fail(err, OVR_IO, "%.400s: ffmpeg: %s", m->path, why);
        m->path = NULL;
        return OVR_IO;
    }
    if (rename(m->made, m->path) != 0)
        return ovr_fail(err, OVR_IO, "%s: %s", m->path, strerror(errno));
    m->path = NULL;
    return OVR_OK;
}

/* Cancels the movie unless it is finished or was never started. */
static void movie_stop(movie_file *m)
{
    if (!m->path)
        return;
    ovr_process_kill(&m->process);
    unlink(m->made);
    m->path = NULL;
}

/* ------------------------------------------------------------------- Frames */

enum { WORKERS = 32 };

typedef struct studio {
    const ovr_frames_options *o;
    ovr_frames_options own;   /* data of `o` */
    ovr_picture_options each; /* data of own.look */
    ovr_arena *arena;
    ovr_stored *runs;
    ovr_snapshot *snapshots;
    size_t count;       /* number of results */
    size_t *which, n;   /* snapshots of the first result to be drawn */
    const char *folder; /* folder of the frames, or a temporary one */
    char temporary[OVR_PATH_SIZE];
    ovr_form form;
    ovr_snapshot_style look;
    ovr_snapshot_chart *chart;
    bool below;            /* with stresses below the surface */
    ovr_areal_view *areal; /* maps of a strip; NULL: curves along x */
    ovr_chart areal_chart;
    ovr_depth_field field;
    ovr_text script, template;
    ovr_gnuplot *gnuplot;
    size_t workers;
    movie_file movie;
    ovr_frames_made *made;
} studio;

/* ----------------------------------------------------------------- choice */

static ovr_status choose_frames(studio *s, ovr_error *err)
{
    const ovr_stored *run = s->runs;
    const ovr_picture_options *look = s->o->look;
    size_t every = s->o->every ? s->o->every : 1;
    s->which = ovr_arena_take(s->arena, run->info->snapshots, sizeof *s->which,
                              err);
    if (!s->which)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < run->info->snapshots; k += every)
        if (!(run->times[k] < look->T_from) && !(run->times[k] > look->T_to))
            s->which[s->n++] = k;
    if (s->n == 0)
        return ovr_fail(err, OVR_BAD_INPUT, "no snapshot between T = %g and %g",
                        look->T_from, look->T_to);
    return OVR_OK;
}

/* Reads the data of frame i. */
static ovr_status read_frame(studio *s, size_t i, ovr_error *err)
{
    double T = s->runs->times[s->which[i]];
    ovr_status status = ovr_snapshot_read(&s->snapshots[0], s->which[i], err);
    for (size_t j = 1; status == OVR_OK && j < s->count; j++)
        status = ovr_snapshot_read(&s->snapshots[j],
                                   ovr_stored_nearest(&s->runs[j], T), err);
    return status;
}

/* Chooses the colour scale of the stress field for the whole run, and its x
 * range for all panels. */
static ovr_status find_field(studio *s, ovr_error *err)
{
    ovr_picture_options *look = &s->each;
    ovr_status status;
    s->below = look->kind == OVR_PICTURE_STRESS;
    if (!s->below)
        return OVR_OK;
    if (s->count > 1)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a picture of stresses shows one result only");
    const ovr_depth_look below = {look->field, look->log_depth, look->surface,
                                  look->x_from, look->x_to};
    status = ovr_depth_field_make(&s->field, s->runs, &below, s->arena, err);
    look->x_from = s->field.x_from;
    look->x_to = s->field.x_to;
    if (look->height <= 0)
        look->height = 960;
    return status;
}

/* Chooses one colour scale for the whole run. */
static ovr_status find_areal(studio *s, ovr_error *err)
{
    ovr_picture_options *look = &s->each;
    if (s->count > 1)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "maps across rolling show one result only");
    if (look->height <= 0)
        look->height = 960;
    s->areal = ovr_arena_take(s->arena, 1, sizeof *s->areal, err);
    ovr_status status = s->areal ? ovr_areal_view_make(s->areal, s->runs, look,
                                                       s->arena, err)
                                 : OVR_NO_MEMORY;
    for (size_t i = 0; !status && i < s->n; i++)
        status = ovr_areal_view_include(s->areal, s->which[i], err);
    return status;
}

static ovr_status find_ranges(studio *s, ovr_error *err)
{
    if (s->each.kind == OVR_PICTURE_AREAL && find_areal(s, err))
        return OVR_BAD_INPUT;
    const ovr_picture_options *look = s->o->look;
    ovr_status status = find_field(s, err);
    ovr_extent extent = ovr_extent_make(look->x_from, look->x_to, s->runs,
                                        s->count);
    for (size_t i = 0; status == OVR_OK && i < s->n; i++) {
        status = read_frame(s, i, err);
        for (size_t j = 0; status == OVR_OK && j < s->count; j++)
            ovr_extent_add(&extent, &s->snapshots[j]);
    }
    if (status == OVR_OK)
        status = ovr_snapshot_style_make(&s->look, look, &extent, s->runs,
                                         s->count, err);
    return status;
}

/* ----------------------------------------------------------------- folder */

static void name_frame(const studio *s, size_t i, const char *suffix,
                       char *path)
{
    snprintf(path, OVR_PATH_SIZE, "%s/frame_%04zu.%s", s->folder, s->which[i],
             suffix);
}

/* Writes all settings that determine a frame in addition to its snapshot. */
static void describe(const studio *s, ovr_text *to)
{
    const ovr_snapshot_style *l = &s->look;
    const ovr_picture_options *o = l->options;
    ovr_text_put(to, "Frames drawn by overroll; existing frames are kept as "
                     "long as these settings do not change.\n");
    ovr_text_print(to, "size %dx%d %s\n", o->width, o->height,
                   ovr_form_names[s->form]);
    ovr_text_print(to, "axes %.9g %s, %.9g %s, %.9g %s, %.9g %s\n", l->x.factor,
                   l->x.plain, l->P.factor, l->P.plain, l->H.factor, l->H.plain,
                   l->T.factor, l->T.plain);
    ovr_text_print(to, "x %.9g to %.9g\npressure to %.9g\nfilm to %.9g\n",
                   l->extent.x_from, l->extent.x_to, l->P_to, l->H_to);
    if (l->extent.hot_high >= l->extent.hot_low)
        ovr_text_print(to, "temperature %.9g to %.9g\n", l->extent.hot_low,
                       l->extent.hot_high);
    ovr_text_print(to, "roughness %.9g to %.9g\nwithout%s%s\ntitle ",
                   l->extent.S_low, l->extent.S_high,
                   o->no_hertz ? " hertz" : "",
                   o->no_roughness ? " roughness" : "");
    ovr_text_gnuplot(to, l->title);
    for (size_t j = 0; j < s->count; j++) {
        ovr_text_put(to, "\nresult ");
        ovr_text_gnuplot(to, s->runs[j].name);
        ovr_text_put(to, " of ");
        ovr_text_gnuplot(to, s->runs[j].info->created);
    }
    if (s->areal)
        ovr_text_print(to, "\nmaps, cuts at %.9g and %.9g", s->areal->line,
                       s->areal->along);
    if (s->below)
        ovr_text_print(to, "\nstress %s to %.9g%s", s->field.name,
                       s->field.high, s->field.logarithmic ? " log" : "");
    ovr_text_print(to, "\ntemplate %08lx\n",
                   crc32(0, (const unsigned char *)s->template.data,
                         (uInt)s->template.length));
}

static bool same_file(const char *path, const ovr_text *text)
{
    FILE *file = fopen(path, "rb");
    size_t i = 0;
    int c = 0;
    if (!file)
        return false;
    while ((c = getc(file)) != EOF && i < text->length)
        if ((char)c != text->data[i++])
            break;
    fclose(file);
    return c == EOF && i == text->length;
}

/* True if the folder contains frames with these settings, which are kept; fails
 * if they have other settings. */
static ovr_status open_folder(studio *s, bool *keep, ovr_error *err)
{
    char path[OVR_PATH_SIZE], first[OVR_PATH_SIZE];
    ovr_text text = ovr_text_make(s->arena);
    ovr_status status;
    *keep = false;
    if (strlen(s->folder) > OVR_PATH_SIZE - 64)
        return ovr_fail(err, OVR_BAD_INPUT, "%.60s...: the name is too long",
                        s->folder);
    if (mkdir(s->folder, 0777) != 0 && errno != EEXIST)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: cannot be created: %s",
                        s->folder, strerror(errno));
    snprintf(path, sizeof path, "%s/frames.txt", s->folder);
    name_frame(s, 0, ovr_form_names[s->form], first);
    describe(s, &text);
    status = ovr_text_status(&text, err);
    if (status == OVR_OK && same_file(path, &text))
        *keep = !s->o->look->force;
    else if (status == OVR_OK && !s->o->look->force &&
             (access(path, F_OK) == 0 || access(first, F_OK) == 0))
        status = ovr_fail(err, OVR_BAD_INPUT,
                          "%s contains frames made with other settings; "
                          "--force replaces them",
                          s->folder);
    if (status == OVR_OK && !*keep)
        status = ovr_text_save(&text, path, err);
    return status;
}

/* Creates a temporary folder next to a movie whose frames are not stored. */
static ovr_status make_temporary(studio *s, const char *movie, ovr_error *err)
{
    const char *slash = strrchr(movie, '/');
    int folder = slash ? (int)(slash - movie) + 1 : 0;
    snprintf(s->temporary, sizeof s->temporary, "%.*s.frames.XXXXXX", folder,
             movie);
    if (!mkdtemp(s->temporary)) {
        s->temporary[0] = '\0';
        return ovr_fail(err, OVR_BAD_INPUT, "%s: cannot be created: %s", movie,
                        strerror(errno));
    }
    s->folder = s->temporary;
    return OVR_OK;
}

/* ---------------------------------------------------------------- drawing */

static ovr_gnuplot *worker_of(studio *s, size_t i)
{
    return &s->gnuplot[s->workers > 1 ? i % s->workers : 0];
}

static ovr_status draw_areal(studio *s, size_t i, const ovr_chart **chart,
                             ovr_error *err)
{
    s->areal_chart = (ovr_chart){.kind = "areal",
                                 .title = s->look.title,
                                 .width = s->each.width > 0 ? s->each.width
                                                            : 1280,
                                 .height = s->each.height};
    *chart = &s->areal_chart;
    return ovr_areal_view_draw(s->areal, s->which[i], &s->areal_chart, err);
}

static ovr_status draw_snapshot(studio *s, ovr_arena *once, ovr_error *err)
{
    ovr_snapshot_draw(s->chart, &s->look, s->snapshots, 1, s->count, NULL);
    s->chart->chart.kind = s->below ? "stress" : "snapshot";
    return s->below ? ovr_stress_panel_add(&s->field, s->snapshots, &s->look,
                                           s->chart, once, err)
                    : OVR_OK;
}

static ovr_status request_frame(studio *s, size_t i, ovr_error *err)
{
    char path[OVR_PATH_SIZE], script[OVR_PATH_SIZE];
    ovr_status status = read_frame(s, i, err);
    if (status != OVR_OK)
        return status;
    name_frame(s, i, ovr_form_names[s->form], path);
    name_frame(s, i, "gp", script);
    ovr_arena once = ovr_arena_make(&s->arena->allocator);
    const ovr_chart *chart = &s->chart->chart;
    if (s->areal)
        status = draw_areal(s, i, &chart, err);
    else
        status = draw_snapshot(s, &once, err);
    s->script.length = 0;
    if (status == OVR_OK)
        ovr_chart_script(chart, &s->template, s->form, &s->script);
    if (status == OVR_OK && s->o->scripts)
        status = ovr_chart_write(chart, &s->template, path, script, &once, err);
    if (status == OVR_OK)
        status = ovr_gnuplot_ask(worker_of(s, i), &s->script, path, err);
    ovr_arena_release(&once);
    if (status == OVR_OK)
        s->made->drawn++;
    return status;
}

/* Waits until frame i is in its file. */
static ovr_status finish_frame(studio *s, size_t i, ovr_error *err)
{
    char path[OVR_PATH_SIZE];
    ovr_status status = ovr_gnuplot_wait(worker_of(s, i), err);
    name_frame(s, i, ovr_form_names[s->form], path);
    if (status == OVR_OK && s->movie.path)
        status = movie_add(&s->movie, path, err);
    if (s->temporary[0])
        unlink(path);
    if (status == OVR_OK && s->o->progress &&
        !s->o->progress(s->o->data, i + 1, s->n))
        status = ovr_fail(err, OVR_STOPPED, "stopped after %zu of %zu frames",
                          i + 1, s->n);
    return status;
}

static ovr_status draw_all(studio *s, bool keep, ovr_error *err)
{
    char path[OVR_PATH_SIZE];
    ovr_status status = OVR_OK;
    for (size_t i = 0; status == OVR_OK && i < s->n + s->workers; i++) {
        if (i >= s->workers)
            status = finish_frame(s, i - s->workers, err);
        if (status != OVR_OK || i >= s->n)
            continue;
        name_frame(s, i, ovr_form_names[s->form], path);
        if (keep && access(path, F_OK) == 0)
            s->made->kept++;
        else
            status = request_frame(s, i, err);
    }
    return status;
}

static ovr_status start_workers(studio *s, ovr_error *err)
{
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    size_t target = s->o->workers > 0 ? (size_t)s->o->workers
                    : cores > 0       ? (size_t)cores
                                      : 1;
    ovr_status status = OVR_OK;
    if (target > WORKERS)
        target = WORKERS;
    if (target > s->n)
        target = s->n;
    s->gnuplot = ovr_arena_take(s->arena, target, sizeof *s->gnuplot, err);
    if (!s->gnuplot)
        return OVR_NO_MEMORY;
    do {
        status = ovr_gnuplot_start(&s->gnuplot[s->workers++], err);
    } while (status == OVR_OK && s->workers < target);
    return status;
}

static void clear_up(studio *s)
{
    char path[OVR_PATH_SIZE];
    for (size_t w = 0; s->gnuplot && w < s->workers; w++)
        ovr_gnuplot_stop(&s->gnuplot[w]);
    movie_stop(&s->movie);
    if (s->below)
        ovr_depth_field_free(&s->field);
    if (!s->temporary[0])
        return;
    for (size_t i = 0; i < s->n; i++) {
        name_frame(s, i, ovr_form_names[s->form], path);
        unlink(path);
    }
    rmdir(s->temporary);
}

/* ------------------------------------------------------------------ frames */

static ovr_status check_form(studio *s, ovr_error *err)
{
    const char *form = s->o->form ? s->o->form : "png";
    for (s->form = OVR_FORM_PNG; s->form < OVR_FORMS; s->form++)
        if (strcmp(form, ovr_form_names[s->form]) == 0)
            break;
    if (s->form == OVR_FORMS)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "frames must be png, svg or pdf, not '%s'", form);
    if (!s->o->folder && !s->o->movie)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "frames need a folder or the name of a movie");
    if (s->o->movie && s->form != OVR_FORM_PNG)
        return ovr_fail(err, OVR_BAD_INPUT, "a movie is made of png frames");
    if (s->count > OVR_SNAPSHOTS)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "at most %d results fit into a picture", OVR_SNAPSHOTS);
    return OVR_OK;
}

static ovr_status prepare(studio *s, ovr_result *const *results, ovr_error *err)
{
    ovr_status status = check_form(s, err);
    if (status == OVR_OK)
        status = ovr_template_read(s->each.template_path, &s->template, err);
    s->runs = ovr_arena_take(s->arena, s->count, sizeof *s->runs, err);
    s->snapshots = ovr_arena_take(s->arena, s->count, sizeof *s->snapshots,
                                  err);
    s->chart = ovr_arena_take(s->arena, 1, sizeof *s->chart, err);
    if (status == OVR_OK && (!s->runs || !s->snapshots || !s->chart))
        status = OVR_NO_MEMORY;
    if (status == OVR_OK)
        status = ovr_open_stored(results, s->count, &s->each, s->runs, s->arena,
                                 err);
    for (size_t j = 0; status == OVR_OK && j < s->count; j++)
        status = ovr_snapshot_make(&s->snapshots[j], &s->runs[j], s->arena,
                                   err);
    if (status == OVR_OK)
        status = choose_frames(s, err);
    if (status == OVR_OK)
        status = find_ranges(s, err);
    return status;
}

static ovr_status make(studio *s, ovr_error *err)
{
    bool keep = false;
    double rate = s->o->rate > 0 ? s->o->rate : 25;
    ovr_status status = OVR_OK;
    if (s->o->movie)
        status = ovr_may_create(s->o->movie, s->o->look->force, err);
    if (status == OVR_OK && s->folder)
        status = open_folder(s, &keep, err);
    else if (status == OVR_OK && s->o->movie)
        status = make_temporary(s, s->o->movie, err);
    if (status == OVR_OK)
        status = start_workers(s, err);
    if (status == OVR_OK && s->o->movie)
        status = movie_start(&s->movie, s->o->movie, rate, err);
    if (status == OVR_OK)
        status = draw_all(s, keep, err);
    if (status == OVR_OK && s->o->movie)
        status = movie_finish(&s->movie, err);
    return status;
}

static ovr_status copy_options(studio *s, const ovr_frames_options *given,
                               ovr_error *err)
{
    ovr_status status = OVR_TAKE(ovr_frames_options, &s->own, given, err);
    s->each = ovr_picture_options_default();
    if (!status && s->own.look)
        status = OVR_TAKE(ovr_picture_options, &s->each, s->own.look, err);
    s->own.look = &s->each;
    s->o = &s->own;
    return status;
}

ovr_status ovr_frames(ovr_result *const *results, size_t count,
                      const ovr_frames_options *options,
                      const ovr_allocator *allocator, ovr_frames_made *made,
                      ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    studio *s = ovr_arena_take(&arena, 1, sizeof *s, err);
    ovr_frames_made unasked = {0, 0};
    ovr_status status;
    locale_t before;
    if (!s)
        return OVR_NO_MEMORY;
    status = copy_options(s, options, err);
    if (status) {
        ovr_arena_release(&arena);
        return status;
    }
    before = ovr_plain_begin();
    s->arena = &arena;
    s->count = count;
    s->folder = s->own.folder;
    s->made = made ? made : &unasked;
    *s->made = (ovr_frames_made){0, 0};
    s->script = ovr_text_make(&arena);
    s->template = ovr_text_make(&arena);
    status = prepare(s, results, err);
    if (status == OVR_OK)
        status = make(s, err);
    clear_up(s);
    ovr_arena_release(&arena);
    ovr_plain_end(before);
    return status;
}
