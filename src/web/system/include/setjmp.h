/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Missing in wasi. The page calls nothing that uses setjmp. */
#ifndef OVR_WEB_SETJMP_H
#define OVR_WEB_SETJMP_H
typedef int jmp_buf[1];
#define setjmp(place) 0
#define longjmp(place, value) __builtin_trap()
#endif
