/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers in files have a point, whatever locale the program has chosen. */
#ifndef OVR_BASE_PLAIN_H
#define OVR_BASE_PLAIN_H

#include <locale.h>

/* Makes printf use the C locale in this thread between begin and end; `end`
 * restores the value returned by begin. */
locale_t ovr_plain_begin(void);
void ovr_plain_end(locale_t before);

#endif
