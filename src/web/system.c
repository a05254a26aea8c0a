/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions missing in wasi (wasi.h), and FFTW in single precision. */
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <fftw3.h>

#undef fcntl

static int none(void)
{
    errno = ENOSYS;
    return -1;
}

int flock(int fd, int how)
{
    (void)fd;
    (void)how;
    return 0;
}

/* File locks always succeed, because no other process uses the file. */
int ovr_web_fcntl(int fd, int what, ...)
{
    va_list more;
    int result = 0;
    va_start(more, what);
    if (what == F_GETLK)
        va_arg(more, struct flock *)->l_type = F_UNLCK;
    else if (what != F_SETLK && what != F_SETLKW)
        result = fcntl(fd, what, va_arg(more, int));
    va_end(more);
    return result;
}

int kill(pid_t process, int number)
{
    (void)process;
    (void)number;
    return none();
}

pid_t fork(void)
{
    return none();
}

pid_t getppid(void)
{
    return 1;
}

int pipe(int end[2])
{
    (void)end;
    return none();
}

int dup(int fd)
{
    (void)fd;
    return none();
}

int dup2(int fd, int as)
{
    (void)fd;
    (void)as;
    return none();
}

mode_t umask(mode_t mask)
{
    (void)mask;
    return 0;
}

int chmod(const char *path, mode_t mode)
{
    (void)path;
    (void)mode;
    return 0;
}

int tzset(void)
{
    return 0;
}

/* There are no symbolic links: returns the path itself if it exists. */
char *realpath(const char *restrict path, char *restrict to)
{
    if (access(path, F_OK) != 0)
        return NULL;
    return to ? strcpy(to, path) : strdup(path);
}

char *mkdtemp(char *name)
{
    (void)name;
    none();
    return NULL;
}

/* ------------------------------------------------- FFTW, single precision */

/* The few single-precision transforms are done in double precision: a second
 * FFTW library would be as large as the first. */
struct single {
    int n;
    fftw_complex *work;
    fftw_plan plan;
};

fftwf_plan fftwf_plan_dft_1d(int n, fftwf_complex *in, fftwf_complex *out,
                             int sign, unsigned flags)
{
    struct single *s = malloc(sizeof *s);
    (void)in;
    (void)out;
    if (!s)
        return NULL;
    s->n = n;
    s->work = fftw_malloc((size_t)n * sizeof *s->work);
    s->plan = s->work ? fftw_plan_dft_1d(n, s->work, s->work, sign, flags)
                      : NULL;
    if (s->plan)
        return (fftwf_plan)s;
    fftw_free(s->work);
    free(s);
    return NULL;
}

void fftwf_execute_dft(fftwf_plan plan, fftwf_complex *in, fftwf_complex *out)
{
    const struct single *s = (const struct single *)plan;
    const float(*from)[2] = (const float(*)[2])in;
    float(*to)[2] = (float(*)[2])out;
    double(*work)[2] = (double(*)[2])s->work;
    for (int k = 0; k < s->n; k++)
        for (int part = 0; part < 2; part++)
            work[k][part] = from[k][part];
    fftw_execute(s->plan);
    for (int k = 0; k < s->n; k++)
        for (int part = 0; part < 2; part++)
            to[k][part] = (float)work[k][part];
}

void fftwf_destroy_plan(fftwf_plan plan)
{
    struct single *s = (struct single *)plan;
    if (!s)
        return;
    fftw_destroy_plan(s->plan);
    fftw_free(s->work);
    free(s);
}
