/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Text from outside may be no text at all: what is UTF-8 in it. */
#ifndef OVR_BASE_UTF8_H
#define OVR_BASE_UTF8_H

/* Length of the UTF-8 sequence at s (RFC 3629), 0 when it is none; the NUL at
 * the end is a sequence of length 1. */
int ovr_utf8_sequence(const unsigned char *s);

#endif
