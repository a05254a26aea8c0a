/* SPDX-License-Identifier: GPL-3.0-or-later */
/* GSL's interpolation without its error handler. */
#ifndef OVR_BASE_INTERPOLATION_H
#define OVR_BASE_INTERPOLATION_H

#include <gsl/gsl_interp.h>

#include "overroll/error.h"

/* Creates an interpolation of y as a function of increasing x, for
 * gsl_interp_free(); NULL with OVR_NO_MEMORY or OVR_BAD_INPUT. GSL's handler
 * would abort the program if memory is insufficient. */
gsl_interp *ovr_interpolation(const gsl_interp_type *type, size_t n,
                              const double *x, const double *y, ovr_error *err);

#endif
