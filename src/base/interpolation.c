/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/interpolation.h"

#include <gsl/gsl_errno.h>
#include <pthread.h>

/* GSL's error handler is global. Only one thread at a time switches it off, so
 * that each thread restores the original handler. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

static int make(const gsl_interp_type *type, size_t n, const double *x,
                const double *y, gsl_interp **made)
{
    int code = GSL_ENOMEM;
    pthread_mutex_lock(&lock);
    gsl_error_handler_t *before = gsl_set_error_handler_off();
    *made = gsl_interp_alloc(type, n);
    if (*made)
        code = gsl_interp_init(*made, x, y, n);
    gsl_set_error_handler(before);
    pthread_mutex_unlock(&lock);
    return code;
}

gsl_interp *ovr_interpolation(const gsl_interp_type *type, size_t n,
                              const double *x, const double *y, ovr_error *err)
{
    gsl_interp *made;
    int code = make(type, n, x, y, &made);
    if (!code)
        return made;
    if (made)
        gsl_interp_free(made);
    if (code == GSL_ENOMEM)
        ovr_fail(err, OVR_NO_MEMORY,
                 "out of memory: no space for the table of an interpolation");
    else
        ovr_fail(err, OVR_BAD_INPUT, "interpolation of %zu points: %s", n,
                 gsl_strerror(code));
    return NULL;
}
