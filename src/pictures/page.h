/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Built-in texts, generated as arrays by the build: the page that plays a run,
 * from page.html, page.css and page_*.js, in which @TITLE@ and @DATA@ are to be
 * replaced; and chart.gp, the template by which gnuplot draws charts.
 */
#ifndef OVR_PICTURES_PAGE_H
#define OVR_PICTURES_PAGE_H

#include <stddef.h>

extern const char ovr_page_text[];
extern const size_t ovr_page_bytes;
extern const char ovr_template_text[];
extern const size_t ovr_template_bytes;

#endif
