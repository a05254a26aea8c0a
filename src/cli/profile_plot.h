/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_CLI_PROFILE_PLOT_H
#define OVR_CLI_PROFILE_PLOT_H

#include "overroll/overroll.h"

/* Draws a profile by gnuplot, the kind of picture after the path's ending. */
ovr_status cli_plot_profile(const ovr_profile_view *view, const char *title,
                            const char *path, ovr_error *err);

#endif
