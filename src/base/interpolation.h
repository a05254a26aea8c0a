/* SPDX-License-Identifier: GPL-3.0-or-later */
/* GSL's interpolation, made without the risk of its error handler. */
#ifndef OVR_BASE_INTERPOLATION_H
#define OVR_BASE_INTERPOLATION_H

#include <gsl/gsl_interp.h>

#include "overroll/error.h"

/* An interpolation of y over increasing x, for gsl_interp_free(); NULL with
 * OVR_NO_MEMORY or OVR_BAD_INPUT.  GSL's handler would abort the caller's
 * program where its memory runs out. */
gsl_interp *ovr_interpolation(const gsl_interp_type *type, size_t n,
                              const double *x, const double *y, ovr_error *err);

#endif
