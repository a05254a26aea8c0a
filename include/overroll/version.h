/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The version of the library, defined only here. */
#ifndef OVERROLL_VERSION_H
#define OVERROLL_VERSION_H

#define OVERROLL_VERSION "0.4.0"

#endif
