/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one place where the version stands. */
#ifndef OVERROLL_VERSION_H
#define OVERROLL_VERSION_H

#define OVERROLL_VERSION "0.3.0"

#endif
