/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options of plot, frames and view. */
#ifndef OVR_CLI_PICTURE_OPTIONS_H
#define OVR_CLI_PICTURE_OPTIONS_H

#include "cli/cli.h"

/* Rows of a command's table of options. */
#define CLI_RANGE_OPTIONS                                                      \
    {"hertzian", NULL, "axes in Hertzian units", false},                       \
        {"si", NULL, "axes in SI units (an error if the scales are unknown)",  \
         false},                                                               \
        {"x", "FROM:TO",                                                       \
         "range of positions, such as -0.1mm:0.2mm or, in b, -2:1.5", false},  \
        {"time", "FROM:TO",                                                    \
         "range of times, such as 0:0.2ms or, in b/u_m, "                      \
         "0:2",                                                                \
         false},                                                               \
        {"across", "Y",                                                        \
         "line of a strip, such as 0.1mm or, in b, 0.5; default: strip.shown", \
         false},                                                               \
        {"along", "X", "X of the cut across in maps of a strip; default: 0",   \
         false},                                                               \
        {"p-max", "P", "upper end of the pressure axis, in p_h or GPa",        \
         false},                                                               \
        {"h-max", "H", "upper end of the film thickness axis, in b^2/R or um", \
         false},                                                               \
        {"size", "WxH", "size of the picture in pixels", false},               \
        {"title", "TEXT", "title instead of that of the file; '' for none",    \
         false},                                                               \
        {"no-hertz", NULL, "do not draw the Hertzian pressure", false},        \
        {"no-roughness", NULL, "do not draw the surface height", false},       \
        {"template", "FILE.gp",                                                \
         "gnuplot script to run before drawing, see "                          \
         "overroll-pictures(7)",                                               \
         false},                                                               \
    {                                                                          \
        "force", NULL, "replace existing files", false                         \
    }

/* Reads these options; returns CLI_DONE, or the exit code after printing an
 * error. */
int cli_picture_options(const cli_call *call, ovr_picture_options *options);

/* Reads the options whose numbers may have units, converted by the scales of
 * the first result. */
int cli_picture_ranges(const cli_call *call, const ovr_result *result,
                       ovr_picture_options *options);

enum { CLI_RESULTS = 8 };

/* Selects the line of a strip given by --across. */
int cli_choose_across(const cli_call *call, ovr_result *result);

/* Selects maps as the kind of picture for a strip, unless a kind, a line or an
 * overlay is requested. */
void cli_choose_areal(const cli_call *call, const ovr_result *result,
                      ovr_picture_options *options);

/* Opens the files named on the command line. */
int cli_open_results(const cli_call *call, ovr_result **results);
/* Prints a note if a result without scales makes all axes Hertzian. */
void cli_say_units(const cli_call *call, ovr_result *const *results,
                   ovr_units units);
void cli_close_results(const cli_call *call, ovr_result **results);

/* Returns names of several files for legends, without folders; NULL for a
 * single file. */
const char *const *cli_result_names(const cli_call *call, const char **names);

#endif
