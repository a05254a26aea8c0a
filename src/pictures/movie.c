/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * ffmpeg reads the pictures from its standard input, so that none needs to
 * stay on the disk.  Sizes become even, which the codecs ask for.
 */
#include "pictures/movie.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

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

static ovr_status start(ovr_movie *m, const struct form *form, double rate,
                        ovr_error *err)
{
    char rate_text[40], output[OVR_PATH_SIZE + 8];
    const char *argv[32] = {"ffmpeg", "-nostdin", "-hide_banner", "-loglevel",
                            "error",  "-y",       "-f",           "image2pipe",
                            "-c:v",   "png",      "-framerate",   rate_text,
                            "-i",     "pipe:0"};
    size_t n = 14;
    snprintf(rate_text, sizeof rate_text, "%.6g", rate);
    /* file: keeps ffmpeg from taking a name for a protocol or an option. */
    snprintf(output, sizeof output, "file:%s", m->made);
    for (int k = 0; k < CODEC_WORDS && form->codec[k]; k++)
        argv[n++] = form->codec[k];
    argv[n++] = "-f";
    argv[n++] = form->muxer;
    argv[n++] = output;
    argv[n] = NULL;
    return ovr_process_start(&m->process, argv, "ffmpeg", err);
}

ovr_status ovr_movie_start(ovr_movie *m, const char *path, double rate,
                           ovr_error *err)
{
    const struct form *form = form_of(path);
    ovr_status status;
    memset(m, 0, sizeof *m);
    if (!form)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: a movie's name ends in .mp4, .webm, .gif or .webp",
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

static ovr_status failed(ovr_movie *m, ovr_error *err)
{
    char why[400];
    ovr_process_end(&m->process, why, sizeof why);
    unlink(m->made);
    ovr_fail(err, OVR_IO, "%.400s: ffmpeg: %s", m->path,
             why[0] ? why : "no movie was made");
    m->path = NULL;
    return OVR_IO;
}

ovr_status ovr_movie_add(ovr_movie *m, const char *picture, ovr_error *err)
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

ovr_status ovr_movie_finish(ovr_movie *m, ovr_error *err)
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

void ovr_movie_stop(ovr_movie *m)
{
    if (!m->path)
        return;
    ovr_process_kill(&m->process);
    unlink(m->made);
    m->path = NULL;
}
