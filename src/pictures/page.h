/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The page that plays a run, made when building from page.html, page.css and
 * page_*.js; @TITLE@ and @DATA@ in it are to be replaced. */
#ifndef OVR_PICTURES_PAGE_H
#define OVR_PICTURES_PAGE_H

#include <stddef.h>

extern const char ovr_page_text[];
extern const size_t ovr_page_bytes;

#endif
